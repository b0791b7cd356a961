/* The module itself, and what its parts share. */
#include "core.h"

void raise_fault(Fault fault) {
    switch (fault) {
    case ZERO_DIVISION:
        PyErr_SetString(PyExc_ZeroDivisionError, "float division by zero");
        break;
    case DOMAIN_FAULT:
        PyErr_SetString(PyExc_ValueError, "math domain error");
        break;
    case OVERFLOW_FAULT:
        PyErr_SetString(PyExc_OverflowError, "(34, 'Numerical result out of range')");
        break;
    case PIVOT_LOST:
        PyErr_SetString(PyExc_ArithmeticError, "a pivot is lost");
        break;
    case NO_MEMORY:
        PyErr_NoMemory();
        break;
    default:
        PyErr_SetString(PyExc_SystemError, "no fault");
    }
}

double *new_doubles(Py_ssize_t count) {
    if (count < 0 || count > MOST) {
        PyErr_NoMemory();
        return NULL;
    }
    double *found = PyMem_Malloc(sizeof(double) * (size_t)(count ? count : 1));
    if (!found) PyErr_NoMemory();
    return found;
}

int grown(void **array, Py_ssize_t *capacity, Py_ssize_t needed, size_t size) {
    if (needed <= *capacity) return 0;
    Py_ssize_t room = *capacity ? *capacity : 16;
    while (room < needed && room <= MOST) room *= 2;
    void *found = room > MOST || size > 4096 ? NULL : PyMem_Realloc(*array, size * (size_t)room);
    if (!found) {
        PyErr_NoMemory();
        return -1;
    }
    *array = found;
    *capacity = room;
    return 0;
}

int read_doubles(PyObject *sequence, double *into, Py_ssize_t count) {
    PyObject *fast = PySequence_Fast(sequence, "a sequence of numbers is expected");
    if (!fast) return -1;
    if (PySequence_Fast_GET_SIZE(fast) != count) {
        PyErr_Format(PyExc_ValueError, "%zd numbers are expected, not %zd", count, PySequence_Fast_GET_SIZE(fast));
        Py_DECREF(fast);
        return -1;
    }
    for (Py_ssize_t i = 0; i < count; i++) {
        if (i >= PySequence_Fast_GET_SIZE(fast)) { /* a list that a __float__ has shortened */
            PyErr_SetString(PyExc_ValueError, "the sequence changed");
            Py_DECREF(fast);
            return -1;
        }
        PyObject *item = PySequence_Fast_GET_ITEM(fast, i);
        if (PyFloat_CheckExact(item)) {
            into[i] = PyFloat_AS_DOUBLE(item);
            continue;
        }
        Py_INCREF(item);
        into[i] = PyFloat_AsDouble(item);
        Py_DECREF(item);
        if (into[i] == -1.0 && PyErr_Occurred()) {
            Py_DECREF(fast);
            return -1;
        }
    }
    Py_DECREF(fast);
    return 0;
}

PyObject *tuple_of(const double *values, Py_ssize_t count) {
    PyObject *found = PyTuple_New(count);
    for (Py_ssize_t i = 0; found && i < count; i++) {
        PyObject *item = PyFloat_FromDouble(values[i]);
        if (!item) Py_CLEAR(found);
        else PyTuple_SET_ITEM(found, i, item);
    }
    return found;
}

PyObject *list_of(const double *values, Py_ssize_t count) {
    PyObject *found = PyList_New(count);
    for (Py_ssize_t i = 0; found && i < count; i++) {
        PyObject *item = PyFloat_FromDouble(values[i]);
        if (!item) Py_CLEAR(found);
        else PyList_SET_ITEM(found, i, item);
    }
    return found;
}

int get_doubles(PyObject *object, Py_buffer *view, Py_ssize_t count, int writable) {
    int flags = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT | (writable ? PyBUF_WRITABLE : 0);
    if (PyObject_GetBuffer(object, view, flags) < 0) return -1;
    if (view->itemsize == sizeof(double) && view->format && !strcmp(view->format, "d") &&
        (count < 0 || view->len == count * (Py_ssize_t)sizeof(double)))
        return 0;
    PyBuffer_Release(view);
    PyErr_Format(PyExc_ValueError, "a contiguous array of %zd doubles is expected", count);
    return -1;
}

static PyMethodDef functions[] = {
    {"set_up", set_up, METH_VARARGS, NULL},
    {"sample_segments", sample_segments, METH_VARARGS, NULL},
    {"evaluate_mode", evaluate_mode, METH_VARARGS, NULL},
    {"solve_symbols", solve_symbols, METH_O, NULL},
    {"solve", solve, METH_O, NULL},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_core", "The native core of the exact engine.", -1, functions, NULL, NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit__core(void) {
    PyObject *module = PyModule_Create(&definition);
    if (!module) return NULL;
    if (intern_names() < 0 || add_tape_types(module) < 0 || add_program_type(module) < 0 || add_integration_type(module) < 0)
        Py_CLEAR(module);
    return module;
}
