/* Gaussian elimination of small systems that may be singular; see `solve` in linear.py. */
#include "core.h"

#define NEGLIGIBLE 1e-11

/* A system: `count` rows of `size` coefficients, the right side and its scale. */
typedef struct {
    Py_ssize_t size, count, width;
    double *cells;
    Py_ssize_t *pivot_row, *pivot_column, *free; /* each with room for `size`; */
    char *used;
    Py_ssize_t pivots, frees;
} System;

/* Return the scaled sum of the products of two rows, over the entries of the first. */
static double dot(const double *one, const double *other, Py_ssize_t count) {
    double total = 0.0;
    for (Py_ssize_t i = 0; i < count; i++) total += one[i] * other[i];
    return total;
}

/* Divide a row by its largest coefficient and append the scale of its right side. */
static Fault scale_row(double *row, Py_ssize_t size) {
    double largest = fabs(row[0]);
    for (Py_ssize_t i = 1; i < size; i++) largest = greater(largest, fabs(row[i]));
    if (largest != 0.0 && largest != 1.0) {
        double factor = 1.0 / largest;
        for (Py_ssize_t i = 0; i <= size; i++) row[i] = factor * row[i];
    }
    row[size + 1] = row[size];
    return OK;
}

static Fault eliminate(System *system) {
    Py_ssize_t size = system->size, width = system->width;
    for (Py_ssize_t column = 0; column < size; column++) {
        double largest = NEGLIGIBLE;
        Py_ssize_t best = -1;
        for (Py_ssize_t i = 0; i < system->count; i++) {
            double entry = fabs(system->cells[i * width + column]);
            if (!system->used[i] && entry > largest) {
                best = i;
                largest = entry;
            }
        }
        if (best < 0) {
            system->free[system->frees++] = column;
            continue;
        }
        const double *pivot = system->cells + best * width;
        system->used[best] = 1;
        system->pivot_row[system->pivots] = best;
        system->pivot_column[system->pivots++] = column;
        for (Py_ssize_t i = 0; i < system->count; i++) {
            double *row = system->cells + i * width;
            if (system->used[i] || row[column] == 0.0) continue;
            double factor = row[column] / pivot[column], scale = greater(fabs(row[size + 1]), fabs(factor * pivot[size + 1]));
            for (Py_ssize_t k = 0; k < width; k++) row[k] = row[k] - factor * pivot[k];
            row[column] = 0.0;
            row[size + 1] = scale;
        }
    }
    return OK;
}

static PyObject *substituted_back(const System *system, double *x, double load) {
    Py_ssize_t size = system->size;
    for (Py_ssize_t k = system->pivots - 1; k >= 0; k--) {
        const double *row = system->cells + system->pivot_row[k] * system->width;
        Py_ssize_t column = system->pivot_column[k];
        x[column] = (load * row[size] - dot(x, row, size)) / row[column]; /* a pivot is not zero */
    }
    PyObject *found = PyList_New(size);
    for (Py_ssize_t i = 0; found && i < size; i++) {
        PyObject *item = PyFloat_FromDouble(x[i]);
        if (!item) Py_CLEAR(found);
        else PyList_SET_ITEM(found, i, item);
    }
    return found;
}

static PyObject *solutions(const System *system) {
    double *x = new_doubles(system->size);
    PyObject *nulls = x ? PyList_New(0) : NULL, *solution = NULL;
    if (!nulls) goto done;
    int consistent = 1;
    for (Py_ssize_t i = 0; i < system->count; i++) {
        const double *row = system->cells + i * system->width;
        if (!system->used[i] && !(fabs(row[system->size]) <= 100.0 * NEGLIGIBLE * (1.0 + fabs(row[system->size + 1]))))
            consistent = 0;
    }
    memset(x, 0, sizeof(double) * (size_t)system->size);
    solution = substituted_back(system, x, 1.0);
    for (Py_ssize_t k = 0; solution && k < system->frees; k++) {
        memset(x, 0, sizeof(double) * (size_t)system->size);
        x[system->free[k]] = 1.0;
        PyObject *null = substituted_back(system, x, 0.0);
        if (!null || PyList_Append(nulls, null) < 0) Py_CLEAR(solution);
        Py_XDECREF(null);
    }
    if (solution) solution = Py_BuildValue("(NOO)", solution, nulls, consistent ? Py_True : Py_False);
done:
    PyMem_Free(x);
    Py_XDECREF(nulls);
    return solution;
}

/* solve(rows): return a solution, the null vectors, and whether the equations are consistent. */
PyObject *solve(PyObject *module, PyObject *rows) {
    System system = {0};
    PyObject *found = NULL, *list = PySequence_Tuple(rows);
    (void)module;
    if (!list) return NULL;
    system.count = PyTuple_GET_SIZE(list);
    Py_ssize_t entries = system.count ? PySequence_Size(PyTuple_GET_ITEM(list, 0)) : 1;
    if (entries < 0) goto done;
    if (!entries || entries > 100000 || system.count > 100000 || (system.count && entries == 1)) {
        PyErr_SetString(PyExc_ValueError, "a row needs coefficients and a right side");
        goto done;
    }
    system.size = entries - 1;
    system.width = entries + 1;
    system.cells = new_doubles(system.count * system.width);
    system.used = PyMem_Calloc((size_t)(system.count + 1), 1);
    system.pivot_row = PyMem_Calloc(3 * (size_t)entries, sizeof(Py_ssize_t));
    if (!system.cells || !system.used || !system.pivot_row) {
        PyErr_NoMemory();
        goto done;
    }
    system.pivot_column = system.pivot_row + entries;
    system.free = system.pivot_column + entries;
    for (Py_ssize_t i = 0; i < system.count; i++) {
        double *row = system.cells + i * system.width;
        if (read_doubles(PyTuple_GET_ITEM(list, i), row, entries) < 0) goto done;
        scale_row(row, system.size);
    }
    eliminate(&system);
    found = solutions(&system);
done:
    PyMem_Free(system.cells);
    PyMem_Free(system.used);
    PyMem_Free(system.pivot_row);
    Py_DECREF(list);
    return found;
}
