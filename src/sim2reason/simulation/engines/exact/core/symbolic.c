/* Gaussian elimination on symbols and numbers; see `solve_symbolic` in linear.py. */
#include "core.h"

#define NEGLIGIBLE 1e-11
#define LARGEST 10000

/* `count` equations of `width` coefficients and the right side; the pivots' columns and rows in order. */
typedef struct {
    Py_ssize_t count, width, solved, frees;
    PyObject **cells; /* owned */
    double *scale;
    Py_ssize_t *column, *row, *free;
    char *used;
} Equations;

static PyObject **cell(const Equations *self, Py_ssize_t row, Py_ssize_t column) {
    return self->cells + row * (self->width + 1) + column;
}

static int is_zero(PyObject *entry) { return PyFloat_CheckExact(entry) && PyFloat_AS_DOUBLE(entry) == 0.0; }

/* Return the absolute value of a number, or of a symbol at the inputs that its tape received last; check errors. */
static double size_of(PyObject *entry) {
    if (PyFloat_CheckExact(entry)) return fabs(PyFloat_AS_DOUBLE(entry));
    if (Py_TYPE(entry) == SymbolType) return fabs(((Symbol *)entry)->tape->values[((Symbol *)entry)->id]);
    return fabs(PyFloat_AsDouble(entry));
}

/* Replace `*entry` by itself minus factor · other. */
static int subtract_product(PyObject **entry, PyObject *factor, PyObject *other) {
    PyObject *product = PyNumber_Multiply(factor, other);
    PyObject *found = product ? PyNumber_Subtract(*entry, product) : NULL;
    Py_XDECREF(product);
    if (!found) return -1;
    Py_SETREF(*entry, found);
    return 0;
}

static int read_equations(Equations *self, PyObject *equations) {
    for (Py_ssize_t i = 0; i < self->count; i++) {
        PyObject *row = PySequence_Tuple(PyTuple_GET_ITEM(equations, i));
        if (!row) return -1;
        if (PyTuple_GET_SIZE(row) != self->width + 1) {
            Py_DECREF(row);
            PyErr_SetString(PyExc_ValueError, "the equations differ in length");
            return -1;
        }
        double largest = 0.0;
        for (Py_ssize_t k = 0; k <= self->width; k++) {
            *cell(self, i, k) = Py_NewRef(PyTuple_GET_ITEM(row, k));
            if (k == self->width) break;
            double size = size_of(PyTuple_GET_ITEM(row, k));
            largest = k ? greater(largest, size) : size;
        }
        Py_DECREF(row);
        if (PyErr_Occurred()) return -1;
        self->scale[i] = largest != 0.0 ? largest : 1.0;
    }
    return 0;
}

/* Eliminate an unknown from a row by a pivot row. */
static int reduce(const Equations *self, Py_ssize_t row, Py_ssize_t pivot, Py_ssize_t column) {
    if (is_zero(*cell(self, row, column))) return 0;
    PyObject *factor = PyNumber_TrueDivide(*cell(self, row, column), *cell(self, pivot, column));
    PyObject *zero = factor ? PyFloat_FromDouble(0.0) : NULL;
    int failed = !zero;
    if (zero) Py_SETREF(*cell(self, row, column), zero);
    for (Py_ssize_t k = column + 1; !failed && k <= self->width; k++)
        if (!is_zero(*cell(self, pivot, k)))
            failed = subtract_product(cell(self, row, k), factor, *cell(self, pivot, k)) < 0;
    Py_XDECREF(factor);
    return failed ? -1 : 0;
}

static int eliminate(Equations *self) {
    for (Py_ssize_t column = 0; column < self->width; column++) {
        Py_ssize_t best = -1;
        double most = 0.0;
        for (Py_ssize_t i = 0; i < self->count; i++) {
            if (self->used[i]) continue;
            double size = size_of(*cell(self, i, column)) / self->scale[i];
            if (best < 0 || size > most) {
                best = i;
                most = size;
            }
        }
        if (PyErr_Occurred()) return -1;
        if (best < 0 || most <= NEGLIGIBLE) {
            self->free[self->frees++] = column;
            continue;
        }
        self->used[best] = 1;
        for (Py_ssize_t i = 0; i < self->count; i++)
            if (!self->used[i] && reduce(self, i, best, column) < 0) return -1;
        self->column[self->solved] = column;
        self->row[self->solved++] = best;
    }
    return 0;
}

/* Return all unknowns as a list: with the right sides, or with zeros instead and one free unknown that is 1. */
static PyObject *substituted(const Equations *self, Py_ssize_t one) {
    PyObject *found = PyList_New(self->width);
    for (Py_ssize_t i = 0; found && i < self->width; i++) {
        PyObject *number = PyFloat_FromDouble(i == one ? 1.0 : 0.0);
        if (!number) Py_CLEAR(found);
        else PyList_SET_ITEM(found, i, number);
    }
    for (Py_ssize_t k = self->solved - 1; found && k >= 0; k--) {
        Py_ssize_t row = self->row[k], column = self->column[k];
        PyObject *total = one < 0 ? Py_NewRef(*cell(self, row, self->width)) : PyFloat_FromDouble(0.0), *quotient = NULL;
        for (Py_ssize_t i = column + 1; total && i < self->width; i++) {
            PyObject *entry = *cell(self, row, i), *known = PyList_GET_ITEM(found, i);
            if (!is_zero(entry) && !is_zero(known) && subtract_product(&total, entry, known) < 0) Py_CLEAR(total);
        }
        if (total) quotient = PyNumber_TrueDivide(total, *cell(self, row, column));
        Py_XDECREF(total);
        if (!quotient || PyList_SetItem(found, column, quotient) < 0) Py_CLEAR(found);
    }
    return found;
}

/* Return the unknowns, the pairs of each free one's index and unknowns, and the pivots. */
static PyObject *solution(const Equations *self) {
    PyObject *found = substituted(self, -1), *free = found ? PyList_New(0) : NULL;
    PyObject *pivots = free ? PyList_New(0) : NULL;
    int failed = !pivots;
    for (Py_ssize_t k = 0; !failed && k < self->frees; k++) {
        PyObject *numbers = substituted(self, self->free[k]);
        PyObject *pair = numbers ? Py_BuildValue("(nN)", self->free[k], numbers) : NULL;
        failed = !pair || PyList_Append(free, pair) < 0;
        Py_XDECREF(pair);
    }
    for (Py_ssize_t k = 0; !failed && k < self->solved; k++)
        failed = PyList_Append(pivots, *cell(self, self->row[k], self->column[k])) < 0;
    PyObject *all = failed ? NULL : PyTuple_Pack(3, found, free, pivots);
    Py_XDECREF(found);
    Py_XDECREF(free);
    Py_XDECREF(pivots);
    return all;
}

/* solve_symbols(equations): return the unknowns, those of each free one, and the pivots; at least one equation. */
PyObject *solve_symbols(PyObject *module, PyObject *argument) {
    Equations self = {0};
    PyObject *equations = PySequence_Tuple(argument), *found = NULL;
    (void)module;
    if (!equations) return NULL;
    self.count = PyTuple_GET_SIZE(equations);
    Py_ssize_t entries = self.count ? PySequence_Size(PyTuple_GET_ITEM(equations, 0)) : 0;
    if (entries < 1 || entries > LARGEST || self.count > LARGEST) {
        if (!PyErr_Occurred()) PyErr_SetString(PyExc_ValueError, "there are no equations, or too many");
        Py_DECREF(equations);
        return NULL;
    }
    self.width = entries - 1;
    self.cells = PyMem_Calloc((size_t)(self.count * entries), sizeof(PyObject *));
    self.scale = new_doubles(self.count);
    self.column = PyMem_Calloc(3 * (size_t)entries, sizeof(Py_ssize_t));
    self.used = PyMem_Calloc((size_t)self.count, 1);
    if (!self.cells || !self.scale || !self.column || !self.used) {
        PyErr_NoMemory();
    } else {
        self.row = self.column + entries;
        self.free = self.row + entries;
        if (read_equations(&self, equations) == 0 && eliminate(&self) == 0) found = solution(&self);
    }
    for (Py_ssize_t i = 0; self.cells && i < self.count * entries; i++) Py_XDECREF(self.cells[i]);
    PyMem_Free(self.cells);
    PyMem_Free(self.scale);
    PyMem_Free(self.column);
    PyMem_Free(self.used);
    Py_DECREF(equations);
    return found;
}
