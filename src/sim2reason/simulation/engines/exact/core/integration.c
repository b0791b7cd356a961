/* The integration of one contact mode to its first event, and samples of it; see flow.py. */
#include "core.h"

#include <structmember.h>

#define MIN_STEP 1e-13
#define OFF 1e-6
#define TIE 1e-10
#define POLISHES 4
#define REST_SPEED 1e-11
#define STEPS_BEFORE_ESTIMATE 200
#define WIDTH (1 + 1 + STAGES - 3 + COEFFICIENTS) /* numbers of a step for each unknown, beside its time and length */

/* Why `advance` returns: the end or an event; or what Python decides about. */
enum { ENDED, DUE, ESTIMATE, SHORT, SPENT, PARTED };

typedef struct {
    double time;
    Py_ssize_t coordinate;
} Turn;

typedef struct {
    PyObject_HEAD
    Program *rate, *margins, *closing, *held; /* `held` may be NULL */
    Py_ssize_t n, watched, passing, count, attempts, table_room, dense_room, turn_count, turn_room;
    Py_ssize_t *passing_margins; /* the indices of the margins that may pass through zero unseen */
    double time, length, tolerance[2];
    double *values, *first, *before, *after, *middle; /* present values and rates; margins of the step */
    double *room, *work;                              /* room of each margin; scratch */
    double *trial, *polished, *table;                 /* steps, as `step_in` lays them out */
    int trial_dense, polished_dense, *dense, begun;
    char *armed;
    Crossing *crossings;
    double *roots;
    Turn *turns;
} Integration;

static PyTypeObject *IntegrationType, *StepType;

static Step step_in(double *cells, int *dense, Py_ssize_t n) {
    Step step = {cells[0], cells[1], cells + 2, cells + 2 + n, cells + 2 + 2 * n, cells + 2 + (WIDTH - COEFFICIENTS) * n,
                 dense};
    return step;
}

static Py_ssize_t stride(const Integration *self) { return 2 + WIDTH * self->n; }

/* ---- event functions within a step */

typedef struct {
    Integration *self;
    Step step;
    Py_ssize_t number;
    double room, start, sign;
} At;

/* Run a program at a fraction x of a step. */
static Fault run_at(At *at, Program *program, double x) {
    Integration *self = at->self;
    double *values = self->work + (STAGES + 1) * self->n;
    Fault fault = step_dense(&at->step, self->rate, self->n, self->work);
    if (fault) return fault;
    for (Py_ssize_t i = 0; i < self->n; i++)
        values[i] = step_at(at->step.values[i], at->step.polynomial + i * COEFFICIENTS, x);
    return program_run(program, at->step.time + x * at->step.length, values);
}

static Fault margin_at(void *context, double x, double *value) {
    At *at = context;
    Program *margins = at->self->margins;
    Fault fault = run_at(at, margins, x);
    *value = margins->cells[margins->output[at->number]] + at->room;
    return fault;
}

/* Without adding `room`, which turns −0 into 0. */
static Fault plain_margin_at(void *context, double x, double *value) {
    At *at = context;
    Program *margins = at->self->margins;
    Fault fault = run_at(at, margins, x);
    *value = margins->cells[margins->output[at->number]];
    return fault;
}

static Fault nearing_at(void *context, double x, double *value) {
    At *at = context;
    Program *closing = at->self->closing;
    Fault fault = run_at(at, closing, x);
    *value = -closing->cells[closing->output[at->number]];
    return fault;
}

static Fault speed_at(void *context, double x, double *value) {
    At *at = context;
    *value = at->sign * step_at(at->start, at->step.polynomial + at->number * COEFFICIENTS, x);
    return OK;
}

static void watch_start(Integration *self) {
    for (Py_ssize_t i = 0; i < self->watched; i++) {
        double margin = self->before[i];
        self->armed[i] = margin > ARMED;
        self->room[i] = -1e-7 < margin && margin < 0.0 ? ARMED - margin : margin >= 0.0 ? ARMED : 0.0;
    }
}

static void watch_passed(Integration *self, const double *after) {
    for (Py_ssize_t i = 0; i < self->watched; i++) self->armed[i] = self->armed[i] || after[i] > ARMED;
}

/* Find the crossings of all margins within a step; returns their number by `count`. */
static Fault find_crossings(Integration *self, const Step *step, Py_ssize_t *count) {
    At at = {self, *step, 0, 0.0, 0.0, 0.0};
    Fault fault = run_at(&at, self->margins, 0.5);
    *count = 0;
    for (Py_ssize_t i = 0; !fault && i < self->watched; i++)
        self->middle[i] = self->margins->cells[self->margins->output[i]];
    for (Py_ssize_t i = 0; !fault && i < self->watched; i++) {
        double values[3] = {self->before[i], self->middle[i], self->after[i]};
        double least = lesser(lesser(values[0], values[1]), values[2]);
        int found;
        if (!(least <= fabs(values[0] - values[1]) + fabs(values[1] - values[2]))) continue;
        at.number = i;
        Crossing *crossing = self->crossings + *count;
        fault = first_crossing(plain_margin_at, &at, values, self->armed[i], self->room[i], crossing, &found);
        crossing->number = i;
        if (!fault && found) ++*count;
    }
    return fault;
}

static int is_known(const Integration *self, Py_ssize_t count, Py_ssize_t number) {
    for (Py_ssize_t i = 0; i < count; i++)
        if (self->crossings[i].number == number) return 1;
    return 0;
}

/* Add the margins of line points that coincide within a step. */
static Fault find_passes(Integration *self, const Step *step, Py_ssize_t *count) {
    At at = {self, *step, 0, 0.0, 0.0, 0.0};
    Program *closing = self->closing;
    Py_ssize_t known = *count, pairs = self->passing;
    double *first = self->work + (STAGES + 2) * self->n, *last = first + 2 * pairs;
    if (!pairs) return OK;
    for (int end = 0; end < 2; end++) {
        Fault fault = run_at(&at, closing, (double)end);
        if (fault) return fault;
        for (Py_ssize_t i = 0; i < 2 * pairs; i++) (end ? last : first)[i] = closing->cells[closing->output[i]];
    }
    for (Py_ssize_t i = 0; i < pairs; i++) {
        double nearest;
        if (!(first[i] < 0.0 && 0.0 < last[i]) || is_known(self, known, self->passing_margins[i])) continue;
        at.number = i;
        Fault fault = bracketed_root(nearing_at, &at, 0.0, 1.0, &nearest);
        if (fault || (fault = run_at(&at, closing, nearest))) return fault;
        if (closing->cells[closing->output[pairs + i]] <= 0.0)
            self->crossings[(*count)++] = (Crossing){self->passing_margins[i], 0.0, nearest, 0.0};
    }
    return OK;
}

/* ---- steps that are kept */

/* Record the instants within a step at which speeds pass through zero. */
static Fault note_turns(Integration *self, const Step *step) {
    Py_ssize_t half = self->n / 2;
    for (Py_ssize_t number = half; number < self->n; number++) {
        double old = step->values[number], new = step->end[number], x;
        if (!(old * new < 0.0 && fabs(old) > REST_SPEED && fabs(new) > REST_SPEED)) continue;
        At at = {self, *step, number, 0.0, old, old > 0.0 ? 1.0 : -1.0};
        Fault fault = step_dense(&at.step, self->rate, self->n, self->work);
        if (fault || (fault = bracketed_root(speed_at, &at, 0.0, 1.0, &x))) return fault;
        if (grown((void **)&self->turns, &self->turn_room, self->turn_count + 1, sizeof(Turn)) < 0) return NO_MEMORY;
        self->turns[self->turn_count++] = (Turn){step->time + x * step->length, number - half};
    }
    return OK;
}

static Fault keep(Integration *self, const double *cells, int *dense) {
    Step step = step_in((double *)cells, dense, self->n);
    Fault fault = note_turns(self, &step);
    if (fault) return fault;
    Py_ssize_t width = stride(self);
    if (self->count >= MOST / width ||
        grown((void **)&self->table, &self->table_room, (self->count + 1) * width, sizeof(double)) < 0 ||
        grown((void **)&self->dense, &self->dense_room, self->count + 1, sizeof(int)) < 0)
        return NO_MEMORY;
    memcpy(self->table + self->count * width, cells, sizeof(double) * (size_t)width);
    self->dense[self->count++] = *dense;
    self->time = step.time + step.length;
    memcpy(self->values, step.end, sizeof(double) * (size_t)self->n);
    return OK;
}

/* Keep a step that ends at an event, predicted at fraction x of `step`; return its length, 0 if there is none. */
static Fault polish(Integration *self, const Step *step, double x, Py_ssize_t number, double room, double *length) {
    At at = {self, *step, number, 0.0, 0.0, 0.0};
    double width = 0.0 < x && x < 1.0 ? 1e-4 * lesser(x, 1.0 - x) : 1e-6, above, below, error;
    Fault fault = plain_margin_at(&at, x + width, &above);
    if (fault || (fault = plain_margin_at(&at, x - width, &below))) return fault;
    double span = 2.0 * width * step->length;
    if (span == 0.0) return ZERO_DIVISION;
    double slope = (above - below) / span;
    double *cells = self->polished;
    memcpy(cells, self->trial, sizeof(double) * (size_t)stride(self)); /* the same start, values and first rates */
    *length = x * step->length;
    for (int turn = 0; turn < POLISHES; turn++) {
        if (*length <= 0.0) {
            *length = 0.0;
            return OK;
        }
        cells[1] = *length;
        Step tried = step_in(cells, &self->polished_dense, self->n);
        if ((fault = step_attempt(&tried, self->rate, self->n, self->tolerance, self->work, &error))) return fault;
        if ((fault = program_run(self->margins, step->time + *length, tried.end))) return fault;
        double missed = self->margins->cells[self->margins->output[number]] + room;
        double change = slope != 0.0 ? -missed / slope : 0.0;
        if (fabs(change) <= 1e-15 * (step->time + *length) ||
            !(0.0 < *length + change && *length + change <= 1.5 * step->length))
            break;
        *length += change;
    }
    cells[1] = *length;
    Step tried = step_in(cells, &self->polished_dense, self->n);
    if ((fault = step_attempt(&tried, self->rate, self->n, self->tolerance, self->work, &error))) return fault;
    return keep(self, cells, &self->polished_dense);
}

/* Truncate the trial step at its first event; `due` receives the number of margins due, whose indices are in
 * `crossings`. */
static Fault truncate_at_event(Integration *self, const Step *step, double tie, Py_ssize_t *due) {
    Py_ssize_t count, leader = 0;
    double length;
    *due = 0;
    if (!self->watched) return OK;
    Fault fault = find_crossings(self, step, &count);
    if (fault || (fault = find_passes(self, step, &count)) || !count) return fault;
    for (Py_ssize_t i = 0; i < count; i++) {
        const Crossing *crossing = self->crossings + i;
        At at = {self, *step, crossing->number, crossing->room, 0.0, 0.0};
        if ((fault = bracketed_root(margin_at, &at, crossing->low, crossing->high, self->roots + i))) return fault;
    }
    for (Py_ssize_t i = 1; i < count; i++) /* the least by root, then by number; none of both is twice there */
        if (self->roots[i] < self->roots[leader] ||
            (self->roots[i] == self->roots[leader] && self->crossings[i].number < self->crossings[leader].number))
            leader = i;
    double soonest = self->roots[leader];
    Crossing first = self->crossings[leader];
    if ((fault = polish(self, step, soonest, first.number, first.room, &length)) || !(length >= 0.0)) return fault;
    for (Py_ssize_t i = 0; i < count; i++)
        if ((self->roots[i] - soonest) * step->length <= tie) self->crossings[(*due)++] = self->crossings[i];
    return OK;
}

/* ---- the main loop */

static PyObject *stopped(Integration *self, int why, Py_ssize_t due) {
    PyObject *numbers = PyTuple_New(due);
    for (Py_ssize_t i = 0; numbers && i < due; i++) {
        PyObject *number = PyLong_FromSsize_t(self->crossings[i].number);
        if (!number) Py_CLEAR(numbers);
        else PyTuple_SET_ITEM(numbers, i, number);
    }
    return numbers ? Py_BuildValue("iN", why, numbers) : NULL;
}

/* Return whether the acting rows are violated by more than rounding and integration explain. */
static Fault check_held(Integration *self, int *parted) {
    *parted = 0;
    if (!self->held) return OK;
    Fault fault = program_run(self->held, self->time, self->values);
    double worst = 0.0;
    for (Py_ssize_t i = 0; !fault && i < self->held->outputs; i++) {
        double size = fabs(self->held->cells[self->held->output[i]]);
        worst = i ? greater(worst, size) : size;
    }
    *parted = worst > OFF;
    return fault;
}

/* Attempt one step and keep it if its error allows; `why` is negative unless something ends or interrupts the loop. */
static Fault one_step(Integration *self, double longest, int *why, Py_ssize_t *due) {
    double error;
    int parted;
    Step step;
    *why = -1;
    self->trial[0] = self->time;
    self->trial[1] = self->length;
    step = step_in(self->trial, &self->trial_dense, self->n);
    memcpy(step.values, self->values, sizeof(double) * (size_t)self->n);
    memcpy(step.rates, self->first, sizeof(double) * (size_t)self->n);
    self->attempts++;
    Fault fault = step_attempt(&step, self->rate, self->n, self->tolerance, self->work, &error);
    if (fault == ZERO_DIVISION || fault == OVERFLOW_FAULT || fault == DOMAIN_FAULT) {
        self->length *= 0.1; /* somewhere ahead; nearer, a pivot is lost before */
        return OK;
    }
    if (fault) return fault;
    if (!(error <= 1.0)) {
        self->length *= isfinite(error) ? lesser(0.5, step_factor(error)) : 0.1;
        return OK;
    }
    if ((fault = program_outputs(self->margins, step.time + self->length, step.end, self->after))) return fault;
    if ((fault = truncate_at_event(self, &step, TIE * longest, due))) return fault;
    if (*due) {
        *why = DUE;
        return OK;
    }
    if ((fault = keep(self, self->trial, &self->trial_dense)) || (fault = check_held(self, &parted))) return fault;
    if (parted) {
        *why = PARTED;
        return OK;
    }
    memcpy(self->first, step.rates + LAST * self->n, sizeof(double) * (size_t)self->n);
    memcpy(self->before, self->after, sizeof(double) * (size_t)self->watched);
    watch_passed(self, self->after);
    self->length *= step_factor(error);
    if (self->count % STEPS_BEFORE_ESTIMATE == 0) *why = ESTIMATE;
    return OK;
}

static PyObject *integration_advance(PyObject *object, PyObject *arguments) {
    Integration *self = (Integration *)object;
    double end, longest;
    Py_ssize_t allowed;
    if (!PyArg_ParseTuple(arguments, "ddn", &end, &longest, &allowed)) return NULL;
    if (!self->begun) {
        PyErr_SetString(PyExc_ValueError, "the integration has not begun");
        return NULL;
    }
    self->attempts = 0;
    while (self->time < end) {
        int why;
        Py_ssize_t due = 0;
        self->length = lesser(self->length, end - self->time);
        if (!(self->length >= MIN_STEP * longest) && end - self->time > MIN_STEP * longest)
            return stopped(self, SHORT, 0);
        if (self->attempts >= allowed) return stopped(self, SPENT, 0);
        Fault fault = one_step(self, longest, &why, &due);
        if (fault) {
            raise_fault(fault);
            return NULL;
        }
        if (why >= 0) return stopped(self, why, due);
    }
    return stopped(self, ENDED, 0);
}

/* begin(absolute, relative): choose the tolerance and the first step. */
static PyObject *integration_begin(PyObject *object, PyObject *arguments) {
    Integration *self = (Integration *)object;
    double absolute, relative, scale;
    if (!PyArg_ParseTuple(arguments, "dd", &absolute, &relative)) return NULL;
    Fault fault = program_outputs(self->rate, self->time, self->values, self->first);
    if (!fault) fault = motion_scale(self->rate, self->time, self->values, self->first, self->n, self->work, &scale);
    if (!fault) {
        self->tolerance[0] = absolute * scale;
        self->tolerance[1] = relative;
        fault = program_outputs(self->margins, self->time, self->values, self->before);
    }
    if (!fault) {
        watch_start(self);
        fault = first_step(self->rate, self->time, self->values, self->first, self->n, self->tolerance, self->work,
                           &self->length);
    }
    if (fault) {
        raise_fault(fault);
        return NULL;
    }
    self->begun = 1;
    Py_RETURN_NONE;
}

/* resume(time, values, keeps): continue from elsewhere, with the steps so far or without. */
static PyObject *integration_resume(PyObject *object, PyObject *arguments) {
    Integration *self = (Integration *)object;
    double time;
    PyObject *values;
    int keeps;
    if (!PyArg_ParseTuple(arguments, "dOp", &time, &values, &keeps)) return NULL;
    if (read_doubles(values, self->values, self->n) < 0) return NULL;
    self->time = time;
    if (!keeps) self->count = 0;
    Fault fault = program_outputs(self->rate, time, self->values, self->first);
    if (!fault) fault = program_outputs(self->margins, time, self->values, self->before);
    if (fault) {
        raise_fault(fault);
        return NULL;
    }
    watch_passed(self, self->before);
    Py_RETURN_NONE;
}

/* ---- what Python reads */

/* Return the turns since the last call, each as (time, coordinate). */
static PyObject *integration_take_turns(PyObject *object, PyObject *unused) {
    Integration *self = (Integration *)object;
    PyObject *found = PyList_New(self->turn_count);
    (void)unused;
    for (Py_ssize_t i = 0; found && i < self->turn_count; i++) {
        PyObject *turn = Py_BuildValue("(dn)", self->turns[i].time, self->turns[i].coordinate);
        if (!turn) Py_CLEAR(found);
        else PyList_SET_ITEM(found, i, turn);
    }
    if (found) self->turn_count = 0;
    return found;
}

/* Return how many of `count` increasing times, `width` numbers apart, are not after a time. */
static Py_ssize_t rank(const double *times, Py_ssize_t count, Py_ssize_t width, double time) {
    Py_ssize_t low = 0, high = count;
    while (low < high) {
        Py_ssize_t middle = low + (high - low) / 2;
        if (times[middle * width] <= time) low = middle + 1;
        else high = middle;
    }
    return low;
}

/* Evaluate coordinates and rates at a time; there must be steps. */
static Fault sampled_at(Integration *self, double time, double *q, double *v) {
    Py_ssize_t width = stride(self), at = rank(self->table, self->count, width, time), half = self->n / 2;
    if (at > 0) at--;
    Step step = step_in(self->table + at * width, self->dense + at, self->n);
    Fault fault = step_dense(&step, self->rate, self->n, self->work);
    if (fault) return fault;
    double x = (time - step.time) / step.length;
    for (Py_ssize_t i = 0; i < self->n; i++)
        (i < half ? q : v - half)[i] = step_at(step.values[i], step.polynomial + i * COEFFICIENTS, x);
    return OK;
}

/* sample(times, into): all unknowns at m instants within the steps, (m, n). */
static PyObject *integration_sample(PyObject *object, PyObject *arguments) {
    Integration *self = (Integration *)object;
    PyObject *times, *into;
    Py_buffer t, found;
    if (!PyArg_ParseTuple(arguments, "OO", &times, &into)) return NULL;
    if (!self->count) {
        PyErr_SetString(PyExc_ValueError, "there are no steps");
        return NULL;
    }
    if (get_doubles(times, &t, -1, 0) < 0) return NULL;
    Py_ssize_t count = t.len / (Py_ssize_t)sizeof(double), n = self->n;
    if (get_doubles(into, &found, count * n, 1) < 0) {
        PyBuffer_Release(&t);
        return NULL;
    }
    Fault fault = OK;
    for (Py_ssize_t k = 0; !fault && k < count; k++)
        fault = sampled_at(self, ((double *)t.buf)[k], (double *)found.buf + k * n, (double *)found.buf + k * n + n / 2);
    PyBuffer_Release(&t);
    PyBuffer_Release(&found);
    if (!fault) Py_RETURN_NONE;
    raise_fault(fault);
    return NULL;
}

/* The segments of a motion: `starts` (s), and of each a row of a table that begins with q, v and a. */
typedef struct {
    const double *starts, *table;
    Py_ssize_t count, width, n;
    PyObject *flows; /* of each segment an integration, or None */
} Segments;

/* Evaluate coordinates and rates at a time; an integration counts no further than to its end. */
static Fault segment_at(const Segments *segments, double time, double *q, double *v) {
    Py_ssize_t n = segments->n, at = rank(segments->starts, segments->count, 1, time);
    if (at > 0) at--;
    PyObject *flow = PyTuple_GET_ITEM(segments->flows, at);
    if (flow != Py_None) {
        Integration *run = (Integration *)flow;
        return sampled_at(run, lesser(time, run->time), q, v);
    }
    const double *row = segments->table + at * segments->width;
    double since = time - segments->starts[at];
    for (Py_ssize_t i = 0; i < n; i++) {
        double gained = since * row[2 * n + i];
        q[i] = row[i] + since * (row[n + i] + 0.5 * gained);
        v[i] = row[n + i] + gained;
    }
    return OK;
}

static int check_flows(PyObject *flows, Py_ssize_t count, Py_ssize_t n) {
    if (PyTuple_GET_SIZE(flows) != count || !count) {
        PyErr_SetString(PyExc_ValueError, "each segment has an integration or None");
        return -1;
    }
    for (Py_ssize_t i = 0; i < count; i++) {
        PyObject *flow = PyTuple_GET_ITEM(flows, i);
        if (flow == Py_None) continue;
        if (Py_TYPE(flow) != IntegrationType || !((Integration *)flow)->count || ((Integration *)flow)->n != 2 * n) {
            PyErr_SetString(PyExc_ValueError, "an integration has no steps, or another number of unknowns");
            return -1;
        }
    }
    return 0;
}

/* sample_segments(starts, table, flows, times, q, v): the motion at m instants, q and v (m, n). */
PyObject *sample_segments(PyObject *module, PyObject *arguments) {
    PyObject *objects[5], *flows;
    Py_buffer views[5]; /* starts, table, times, q, v */
    int got = 0;
    Fault fault = NO_MEMORY;
    (void)module;
    if (!PyArg_ParseTuple(arguments, "OOO!OOO", objects, objects + 1, &PyTuple_Type, &flows, objects + 2, objects + 3,
                          objects + 4))
        return NULL;
    for (; got < 5; got++) {
        Py_ssize_t expected = got == 4 ? views[3].len / (Py_ssize_t)sizeof(double) : -1;
        if (get_doubles(objects[got], views + got, expected, got > 2) < 0) goto done;
    }
    Py_ssize_t sizes[5];
    for (int i = 0; i < 5; i++) sizes[i] = views[i].len / (Py_ssize_t)sizeof(double);
    Py_ssize_t count = sizes[0], instants = sizes[2], n = instants ? sizes[3] / instants : 0;
    Segments segments = {views[0].buf, views[1].buf, count, count ? sizes[1] / count : 0, n, flows};
    if (sizes[3] != n * instants || sizes[1] != count * segments.width || segments.width < 3 * n) {
        PyErr_SetString(PyExc_ValueError, "the arrays do not fit each other");
        goto done;
    }
    if (instants && check_flows(flows, count, n) < 0) goto done;
    fault = OK;
    for (Py_ssize_t k = 0; !fault && k < instants; k++)
        fault = segment_at(&segments, ((double *)views[2].buf)[k], (double *)views[3].buf + k * n,
                           (double *)views[4].buf + k * n);
    if (fault) raise_fault(fault);
done:
    while (got > 0) PyBuffer_Release(views + --got);
    if (fault) return NULL;
    Py_RETURN_NONE;
}

static Py_ssize_t integration_count(PyObject *object) { return ((Integration *)object)->count; }

static PyObject *integration_step(PyObject *object, Py_ssize_t at) {
    Integration *self = (Integration *)object;
    if (at < 0 || at >= self->count) {
        PyErr_SetString(PyExc_IndexError, "there is no such step");
        return NULL;
    }
    PyObject *found = PyStructSequence_New(StepType);
    if (!found) return NULL;
    Step step = step_in(self->table + at * stride(self), self->dense + at, self->n);
    PyStructSequence_SET_ITEM(found, 0, PyFloat_FromDouble(step.time));
    PyStructSequence_SET_ITEM(found, 1, PyFloat_FromDouble(step.length));
    PyStructSequence_SET_ITEM(found, 2, tuple_of(step.values, self->n));
    PyStructSequence_SET_ITEM(found, 3, tuple_of(step.end, self->n));
    if (PyErr_Occurred()) Py_CLEAR(found);
    return found;
}

static PyObject *integration_times(PyObject *object, PyObject *unused) {
    Integration *self = (Integration *)object;
    PyObject *found = PyList_New(self->count);
    (void)unused;
    for (Py_ssize_t i = 0; found && i < self->count; i++) {
        PyObject *time = PyFloat_FromDouble(self->table[i * stride(self)]);
        if (!time) Py_CLEAR(found);
        else PyList_SET_ITEM(found, i, time);
    }
    return found;
}

static PyObject *integration_values(PyObject *object, void *unused) {
    (void)unused;
    return tuple_of(((Integration *)object)->values, ((Integration *)object)->n);
}

static PyMemberDef integration_members[] = {
    {"time", T_DOUBLE, offsetof(Integration, time), READONLY, NULL},
    {"length", T_DOUBLE, offsetof(Integration, length), READONLY, "The size of the next step."},
    {"attempts", T_PYSSIZET, offsetof(Integration, attempts), READONLY, "The attempted steps of the last advance."},
    {NULL, 0, 0, 0, NULL},
};

/* ---- construction */

static void integration_free(PyObject *object) {
    Integration *self = (Integration *)object;
    PyTypeObject *type = Py_TYPE(object);
    Py_XDECREF(self->rate);
    Py_XDECREF(self->margins);
    Py_XDECREF(self->closing);
    Py_XDECREF(self->held);
    void *arrays[] = {self->passing_margins, self->values,   self->first, self->before, self->after, self->middle,
                      self->room,            self->work,     self->trial, self->table,  self->dense, self->polished,
                      self->armed,           self->crossings, self->roots, self->turns};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) PyMem_Free(arrays[i]);
    type->tp_free(object);
    Py_DECREF(type);
}

static int read_passing(Integration *self, PyObject *passing) {
    self->passing = PyTuple_GET_SIZE(passing);
    self->passing_margins = PyMem_Malloc(sizeof(Py_ssize_t) * (size_t)(self->passing ? self->passing : 1));
    if (!self->passing_margins) {
        PyErr_NoMemory();
        return -1;
    }
    for (Py_ssize_t i = 0; i < self->passing; i++) {
        Py_ssize_t number = PyLong_AsSsize_t(PyTuple_GET_ITEM(passing, i));
        if (number == -1 && PyErr_Occurred()) return -1;
        if (number < 0 || number >= self->watched) {
            PyErr_SetString(PyExc_IndexError, "there is no such margin");
            return -1;
        }
        self->passing_margins[i] = number;
    }
    return 0;
}

/* Check that the programs have the same inputs and the right numbers of outputs. */
static int programs_agree(const Integration *self) {
    Py_ssize_t inputs = self->rate->inputs;
    return self->rate->outputs == inputs - 1 && self->margins->inputs == inputs && self->closing->inputs == inputs &&
           self->closing->outputs == 2 * self->passing && (!self->held || self->held->inputs == inputs) &&
           inputs < MOST / 1024 && self->watched < MOST / 1024 && self->passing < MOST / 1024;
}

static int allocate(Integration *self) {
    Py_ssize_t n = self->n, m = self->watched;
    self->values = new_doubles(n);
    self->first = new_doubles(n);
    self->before = new_doubles(m);
    self->after = new_doubles(m);
    self->middle = new_doubles(m);
    self->room = new_doubles(m);
    self->work = new_doubles((STAGES + 2) * n + 4 * self->passing);
    self->trial = new_doubles(stride(self));
    self->polished = new_doubles(stride(self));
    self->roots = new_doubles(m + self->passing);
    self->armed = PyMem_Calloc((size_t)(m ? m : 1), 1);
    self->crossings = PyMem_Calloc((size_t)(m + self->passing + 1), sizeof(Crossing));
    if (!self->values || !self->first || !self->before || !self->after || !self->middle || !self->room || !self->work ||
        !self->trial || !self->polished || !self->roots || !self->armed || !self->crossings) {
        PyErr_NoMemory();
        return -1;
    }
    memset(self->trial, 0, sizeof(double) * (size_t)stride(self)); /* its polynomial is copied before it is computed */
    return 0;
}

static PyObject *integration_new(PyTypeObject *type, PyObject *arguments, PyObject *keywords) {
    static char *names[] = {"rate", "margins", "closing", "held", "passing", "time", "values", NULL};
    PyObject *held, *passing, *values;
    Program *rate, *margins, *closing;
    double time;
    if (!PyArg_ParseTupleAndKeywords(arguments, keywords, "O!O!O!OO!dO", names, ProgramType, &rate, ProgramType,
                                     &margins, ProgramType, &closing, &held, &PyTuple_Type, &passing, &time, &values))
        return NULL;
    if (!has_coefficients() || (held != Py_None && Py_TYPE(held) != ProgramType)) {
        PyErr_SetString(PyExc_TypeError, has_coefficients() ? "held is no program" : "the coefficients are not set");
        return NULL;
    }
    Integration *self = (Integration *)type->tp_alloc(type, 0);
    if (!self) return NULL;
    self->rate = (Program *)Py_NewRef(rate);
    self->margins = (Program *)Py_NewRef(margins);
    self->closing = (Program *)Py_NewRef(closing);
    self->held = held == Py_None ? NULL : (Program *)Py_NewRef(held);
    self->n = rate->inputs - 1;
    self->watched = margins->outputs;
    self->time = time;
    if (read_passing(self, passing) < 0) goto failed;
    if (!programs_agree(self)) {
        PyErr_SetString(PyExc_ValueError, "the programs differ in their inputs, or in the number of their outputs");
        goto failed;
    }
    if (allocate(self) < 0 || read_doubles(values, self->values, self->n) < 0) goto failed;
    return (PyObject *)self;
failed:
    Py_DECREF(self);
    return NULL;
}

static PyMethodDef integration_methods[] = {
    {"begin", integration_begin, METH_VARARGS, "Choose the tolerance and the first step."},
    {"advance", integration_advance, METH_VARARGS, "Integrate to the end, an event, or what needs a decision."},
    {"resume", integration_resume, METH_VARARGS, "Continue from elsewhere, with the steps so far or without."},
    {"take_turns", integration_take_turns, METH_NOARGS, "Return the turns since the last call: time and coordinate."},
    {"sample", integration_sample, METH_VARARGS, "Evaluate all unknowns at instants within the steps."},
    {"times", integration_times, METH_NOARGS, "Return the times at which the steps start."},
    {NULL, NULL, 0, NULL},
};

static PyGetSetDef integration_attributes[] = {
    {"values", integration_values, NULL, "The present coordinates and rates.", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};

static PyType_Slot integration_slots[] = {
    {Py_tp_doc, "The integration of one contact mode: a sequence of its steps."},
    {Py_tp_new, integration_new},
    {Py_tp_dealloc, integration_free},
    {Py_tp_methods, integration_methods},
    {Py_tp_members, integration_members},
    {Py_tp_getset, integration_attributes},
    {Py_sq_length, integration_count},
    {Py_sq_item, integration_step},
    {0, NULL},
};

static PyType_Spec integration_spec = {
    "sim2reason.simulation.engines.exact.core._core.Integration", sizeof(Integration), 0, Py_TPFLAGS_DEFAULT,
    integration_slots,
};

static PyStructSequence_Field step_fields[] = {
    {"time", "its start"}, {"length", NULL}, {"values", "at its start"}, {"new", "values at its end"}, {NULL, NULL},
};

static PyStructSequence_Desc step_description = {
    "sim2reason.simulation.engines.exact.core._core.Step", "One integrator step.", step_fields, 4,
};

int add_integration_type(PyObject *module) {
    IntegrationType = (PyTypeObject *)PyType_FromSpec(&integration_spec);
    StepType = PyStructSequence_NewType(&step_description);
    if (!IntegrationType || !StepType) return -1;
    return PyModule_AddObjectRef(module, "Integration", (PyObject *)IntegrationType) < 0 ||
                   PyModule_AddObjectRef(module, "Step", (PyObject *)StepType) < 0
               ? -1
               : 0;
}
