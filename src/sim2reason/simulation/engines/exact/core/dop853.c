/* One step of the method of Dormand and Prince, its error and its dense output; see dop853.py and motion_scale. */
#include "core.h"

#define API 2 /* the same as in native.py; another one with every change of what the core does */
#define ORDER 8
#define SAFETY 0.9
#define MIN_STEP_RATIO 0.2
#define MAX_STEP_RATIO 8.0
#define UNIT_SIZE_DISPLACEMENT 1e-3
#define NONE 1e-12
#define STEP 1e-8

/* A weighted sum of rates, by the index of the stage. */
typedef struct {
    int count, stage[STAGES];
    double weight[STAGES];
} Weights;

static struct {
    int known;
    double node[STAGES];
    Weights stage[STAGES - 1], fifth, third, dense[COEFFICIENTS - 3];
} table;

int has_coefficients(void) { return table.known; }

/* Read a dict of weights by stage, in its order; stages must be below `limit`. */
static int read_weights(PyObject *dict, Weights *weights, long limit) {
    PyObject *key, *value;
    Py_ssize_t at = 0;
    weights->count = 0;
    if (!PyDict_Check(dict) || PyDict_GET_SIZE(dict) > STAGES || !PyDict_GET_SIZE(dict)) {
        PyErr_SetString(PyExc_ValueError, "weights of stages are expected");
        return -1;
    }
    while (PyDict_Next(dict, &at, &key, &value)) {
        long stage = PyLong_Check(key) ? PyLong_AsLong(key) : -1;
        if (stage < 0 || stage >= limit || !PyFloat_CheckExact(value) || weights->count >= STAGES) {
            PyErr_SetString(PyExc_ValueError, "a stage or its weight is wrong");
            return -1;
        }
        weights->stage[weights->count] = (int)stage;
        weights->weight[weights->count++] = PyFloat_AS_DOUBLE(value);
    }
    return 0;
}

static int read_rows(PyObject *rows, Weights *weights, Py_ssize_t count, long limit, int rising) {
    if (PyTuple_GET_SIZE(rows) != count) {
        PyErr_SetString(PyExc_ValueError, "the number of rows of coefficients is wrong");
        return -1;
    }
    for (Py_ssize_t i = 0; i < count; i++)
        if (read_weights(PyTuple_GET_ITEM(rows, i), weights + i, rising ? (long)i + 1 : limit) < 0) return -1;
    return 0;
}

PyObject *set_up(PyObject *module, PyObject *arguments) {
    PyObject *nodes, *stages, *fifth, *third, *dense;
    int api;
    (void)module;
    table.known = 0;
    if (!PyArg_ParseTuple(arguments, "iO!O!OOO!", &api, &PyTuple_Type, &nodes, &PyTuple_Type, &stages, &fifth, &third,
                          &PyTuple_Type, &dense))
        return NULL;
    if (api != API) {
        PyErr_SetString(PyExc_ImportError, "the native core is of another version: install the package again");
        return NULL;
    }
    if (read_doubles(nodes, table.node, STAGES) < 0 || read_rows(stages, table.stage, STAGES - 1, 0, 1) < 0 ||
        read_weights(fifth, &table.fifth, LAST) < 0 || read_weights(third, &table.third, LAST) < 0 ||
        read_rows(dense, table.dense, COEFFICIENTS - 3, STAGES, 0) < 0)
        return NULL;
    table.known = 1;
    Py_RETURN_NONE;
}

/* ---- a step */

static void weighted(const Weights *weights, const double *rates, Py_ssize_t n, double *sum) {
    const double *first = rates + weights->stage[0] * n;
    double weight = weights->weight[0];
    for (Py_ssize_t i = 0; i < n; i++) sum[i] = weight * first[i];
    for (int j = 1; j < weights->count; j++) {
        const double *next = rates + weights->stage[j] * n;
        weight = weights->weight[j];
        for (Py_ssize_t i = 0; i < n; i++) sum[i] = sum[i] + weight * next[i];
    }
}

/* Evaluate stage `number`; `rates` is (STAGES, n), and `at` has room for the values there. */
static Fault evaluate_stage(int number, const Step *step, Program *rate, Py_ssize_t n, double *rates, double *at) {
    weighted(table.stage + number - 1, rates, n, at);
    for (Py_ssize_t i = 0; i < n; i++) at[i] = step->values[i] + step->length * at[i];
    return program_outputs(rate, step->time + table.node[number] * step->length, at, rates + number * n);
}

/* Square a number as Python's ** does. */
static Fault squared(double x, double *square) {
    *square = pow(x, 2.0);
    return isinf(*square) && isfinite(x) ? OVERFLOW_FAULT : OK;
}

/* Add the squares of the errors of both orders, relative to the tolerance. */
static Fault errors(const Step *step, Py_ssize_t n, const double *tolerance, double *room, double *fifth,
                    double *third) {
    double *one = room, *other = room + n, square;
    weighted(&table.fifth, step->rates, n, one);
    weighted(&table.third, step->rates, n, other);
    *fifth = *third = 0.0;
    for (Py_ssize_t i = 0; i < n; i++) {
        double scale = tolerance[0] + tolerance[1] * greater(fabs(step->values[i]), fabs(step->end[i]));
        if (scale == 0.0) return ZERO_DIVISION;
        Fault fault = squared(one[i] / scale, &square);
        if (fault) return fault;
        *fifth += square;
        fault = squared(other[i] / scale, &square);
        if (fault) return fault;
        *third += square;
    }
    return OK;
}

Fault step_attempt(Step *step, Program *rate, Py_ssize_t n, const double *tolerance, double *room, double *error) {
    Fault fault;
    *step->dense = 0;
    for (int number = 1; number < LAST; number++)
        if ((fault = evaluate_stage(number, step, rate, n, step->rates, room))) return fault;
    weighted(table.stage + LAST - 1, step->rates, n, step->end);
    for (Py_ssize_t i = 0; i < n; i++) step->end[i] = step->values[i] + step->length * step->end[i];
    fault = program_outputs(rate, step->time + step->length, step->end, step->rates + LAST * n);
    if (fault) return fault;
    double fifth, third;
    if ((fault = errors(step, n, tolerance, room, &fifth, &third))) return fault;
    *error = 0.0;
    if (fifth == 0.0) return OK;
    double norm = sqrt((fifth + 0.01 * third) * (double)n);
    if (norm == 0.0) return ZERO_DIVISION;
    *error = fabs(step->length) * fifth / norm;
    return OK;
}

Fault step_dense(Step *step, Program *rate, Py_ssize_t n, double *room) {
    if (*step->dense) return OK;
    double *rates = room, *at = room + STAGES * n, h = step->length;
    memcpy(rates, step->rates, sizeof(double) * (size_t)((STAGES - 3) * n));
    for (int number = LAST + 1; number < STAGES; number++) {
        Fault fault = evaluate_stage(number, step, rate, n, rates, at);
        if (fault) return fault;
    }
    for (Py_ssize_t i = 0; i < n; i++) {
        double *found = step->polynomial + i * COEFFICIENTS, rise = step->end[i] - step->values[i];
        found[0] = rise;
        found[1] = h * rates[i] - rise;
        found[2] = 2.0 * rise - h * (rates[LAST * n + i] + rates[i]);
    }
    for (int k = 0; k < COEFFICIENTS - 3; k++) {
        weighted(table.dense + k, rates, n, at);
        for (Py_ssize_t i = 0; i < n; i++) step->polynomial[i * COEFFICIENTS + 3 + k] = h * at[i];
    }
    *step->dense = 1;
    return OK;
}

double step_at(double start, const double *c, double x) {
    double y = 1.0 - x;
    return start + x * (c[0] + y * (c[1] + x * (c[2] + y * (c[3] + x * (c[4] + y * (c[5] + x * c[6]))))));
}

double step_factor(double error) {
    if (error == 0.0) return MAX_STEP_RATIO;
    return lesser(MAX_STEP_RATIO, greater(MIN_STEP_RATIO, SAFETY * pow(error, -1.0 / ORDER)));
}

/* ---- before the first step */

static Fault norm(const double *values, const double *scales, Py_ssize_t n, double *found) {
    double total = 0.0, square;
    for (Py_ssize_t i = 0; i < n; i++) {
        if (scales[i] == 0.0) return ZERO_DIVISION;
        Fault fault = squared(values[i] / scales[i], &square);
        if (fault) return fault;
        total += square;
    }
    *found = sqrt(total / (double)(n > 1 ? n : 1));
    return OK;
}

Fault first_step(Program *rate, double time, const double *values, const double *first, Py_ssize_t n,
                 const double *tolerance, double *room, double *length) {
    double *scales = room, *at = room + n, *ahead = room + 2 * n, d0, d1, d2;
    Fault fault;
    for (Py_ssize_t i = 0; i < n; i++) scales[i] = tolerance[0] + tolerance[1] * fabs(values[i]);
    if ((fault = norm(values, scales, n, &d0)) || (fault = norm(first, scales, n, &d1))) return fault;
    double h = d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1;
    for (Py_ssize_t i = 0; i < n; i++) at[i] = values[i] + h * first[i];
    if ((fault = program_outputs(rate, time + h, at, ahead))) return fault;
    for (Py_ssize_t i = 0; i < n; i++) ahead[i] = ahead[i] - first[i];
    if ((fault = norm(ahead, scales, n, &d2))) return fault;
    if (h == 0.0) return ZERO_DIVISION;
    double most = greater(d1, d2 / h);
    *length = lesser(100.0 * h, most > 1e-15 ? pow(0.01 / most, 1.0 / ORDER) : greater(1e-6, 1e-3 * h));
    return OK;
}

static double largest(const double *values, Py_ssize_t n) {
    double found = n ? fabs(values[0]) : 0.0;
    for (Py_ssize_t i = 1; i < n; i++) found = greater(found, fabs(values[i]));
    return found;
}

Fault motion_scale(Program *rate, double time, const double *values, const double *first, Py_ssize_t n, double *room,
                   double *scale) {
    double *moved = room, *there = room + n, stiffest = 0.0;
    Py_ssize_t half = n / 2;
    for (Py_ssize_t number = 0; number < half; number++) {
        memcpy(moved, values, sizeof(double) * (size_t)n);
        moved[number] += STEP;
        Fault fault = program_outputs(rate, time, moved, there);
        if (fault) return fault;
        for (Py_ssize_t i = half; i < n; i++) stiffest = greater(stiffest, fabs(there[i] - first[i]) / STEP);
    }
    *scale = 1.0;
    if (!(stiffest > 0.0)) return OK;
    double size = greater(largest(values + half, n - half) / sqrt(stiffest), largest(first + half, n - half) / stiffest);
    if (NONE < size && size < UNIT_SIZE_DISPLACEMENT) *scale = size;
    return OK;
}
