/* Gaussian elimination of small systems that may be singular; see `solve` in linear.py. */
#include "core.h"

#define NEGLIGIBLE 1e-11
#define LARGEST 100000

/* Return the sum of the products of two rows. */
double dot(const double *one, const double *other, Py_ssize_t count) {
    double total = 0.0;
    for (Py_ssize_t i = 0; i < count; i++) total += one[i] * other[i];
    return total;
}

/* Divide a row by its largest coefficient and append the scale of its right side. */
static void scale_row(double *row, Py_ssize_t size) {
    double largest = fabs(row[0]);
    for (Py_ssize_t i = 1; i < size; i++) largest = greater(largest, fabs(row[i]));
    if (largest != 0.0 && largest != 1.0) {
        double factor = 1.0 / largest;
        for (Py_ssize_t i = 0; i <= size; i++) row[i] = factor * row[i];
    }
    row[size + 1] = row[size];
}

static void eliminate(System *system) {
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
}

static void substituted_back(const System *system, double *x, double load) {
    Py_ssize_t size = system->size;
    for (Py_ssize_t k = system->pivots - 1; k >= 0; k--) {
        const double *row = system->cells + system->pivot_row[k] * system->width;
        Py_ssize_t column = system->pivot_column[k];
        x[column] = (load * row[size] - dot(x, row, size)) / row[column]; /* a pivot is not zero */
    }
}

int system_allocate(System *system, Py_ssize_t count, Py_ssize_t size) {
    memset(system, 0, sizeof *system);
    if (count < 0 || size < 0 || count > LARGEST || size > LARGEST) {
        PyErr_SetString(PyExc_ValueError, "the system is too large");
        return -1;
    }
    system->count = count;
    system->size = size;
    system->width = size + 2;
    system->cells = new_doubles(count * system->width);
    system->x = new_doubles(size);
    system->used = PyMem_Calloc((size_t)(count + 1), 1);
    system->pivot_row = PyMem_Calloc(3 * (size_t)(size + 1), sizeof(Py_ssize_t));
    if (!system->cells || !system->x || !system->used || !system->pivot_row) {
        PyErr_NoMemory();
        return -1;
    }
    system->pivot_column = system->pivot_row + size + 1;
    system->free = system->pivot_column + size + 1;
    return 0;
}

void system_free(System *system) {
    PyMem_Free(system->cells);
    PyMem_Free(system->x);
    PyMem_Free(system->used);
    PyMem_Free(system->pivot_row);
}

void system_solve(System *system) {
    Py_ssize_t size = system->size;
    if (size)
        for (Py_ssize_t i = 0; i < system->count; i++) scale_row(system->cells + i * system->width, size);
    eliminate(system);
    system->consistent = 1;
    for (Py_ssize_t i = 0; i < system->count; i++) {
        const double *row = system->cells + i * system->width;
        if (!system->used[i] && !(fabs(row[size]) <= 100.0 * NEGLIGIBLE * (1.0 + fabs(row[size + 1]))))
            system->consistent = 0;
    }
    memset(system->x, 0, sizeof(double) * (size_t)size);
    substituted_back(system, system->x, 1.0);
}

PyObject *system_nulls(const System *system) {
    PyObject *nulls = PyList_New(0);
    double *x = nulls ? new_doubles(system->size) : NULL;
    if (!x) Py_CLEAR(nulls);
    for (Py_ssize_t k = 0; nulls && k < system->frees; k++) {
        memset(x, 0, sizeof(double) * (size_t)system->size);
        x[system->free[k]] = 1.0;
        substituted_back(system, x, 0.0);
        PyObject *null = list_of(x, system->size);
        if (!null || PyList_Append(nulls, null) < 0) Py_CLEAR(nulls);
        Py_XDECREF(null);
    }
    PyMem_Free(x);
    return nulls;
}

/* solve(rows): return a solution, the null vectors, and whether the equations are consistent. */
PyObject *solve(PyObject *module, PyObject *rows) {
    System system = {0};
    PyObject *found = NULL, *x, *nulls, *list = PySequence_Tuple(rows);
    (void)module;
    if (!list) return NULL;
    Py_ssize_t count = PyTuple_GET_SIZE(list), entries = count ? PySequence_Size(PyTuple_GET_ITEM(list, 0)) : 1;
    if (entries < 0) goto done;
    if (!entries || (count && entries == 1)) {
        PyErr_SetString(PyExc_ValueError, "a row needs coefficients and a right side");
        goto done;
    }
    if (system_allocate(&system, count, entries - 1) < 0) goto done;
    for (Py_ssize_t i = 0; i < count; i++)
        if (read_doubles(PyTuple_GET_ITEM(list, i), system.cells + i * system.width, entries) < 0) goto done;
    system_solve(&system);
    x = list_of(system.x, system.size);
    nulls = x ? system_nulls(&system) : NULL;
    if (nulls) found = Py_BuildValue("(NNO)", x, nulls, system.consistent ? Py_True : Py_False);
    else Py_XDECREF(x);
done:
    system_free(&system);
    Py_DECREF(list);
    return found;
}
