/* The forces of one contact mode; see `evaluate`, `_system`, `_forces` and `_flips` in contact_modes.py. */
#include "core.h"

#define TOLERANCE 1e-10

enum { MASS, LIFTED, FORCE, PRESS, ROWS, TARGETS, GRIPS, SLIDING, HELD, LOAD, ALONG, LIFT, CONTACT, SLIP, FRICTION,
       COORDINATE, BOTH, HOLDS, NAMES };

static const char *const texts[NAMES] = {
    "mass", "lifted", "force", "press", "rows",     "targets",    "grips", "sliding", "held",
    "load", "along",  "lift",  "contact", "slip",   "friction",   "coordinate", "both", "holds",
};
static PyObject *names[NAMES];

int intern_names(void) {
    for (int i = 0; i < NAMES; i++)
        if (!names[i] && !(names[i] = PyUnicode_InternFromString(texts[i]))) return -1;
    return 0;
}

/* A rough contact, with its side in the mode. */
typedef struct {
    Py_ssize_t contact, coordinate;
    double friction, holds;
    const double *along;
    int both, side, sliding;
} Grip;

/* A problem of n coordinates, c contacts, `rows` constraints and `grips` rough contacts, and a mode. */
typedef struct {
    Py_ssize_t n, c, rows, grips, active, extra;
    double *cells, *mass, *lifted, *force, *press, *targets, *along, *lift, *slips, *x, *multiplier, *normal, *friction;
    double load;
    char *acting, *held;
    Grip *grip;
} Contacts;

/* Return an attribute as a tuple or list of its own, NULL and an exception if it is none. */
static PyObject *sequence_at(PyObject *object, int name) {
    PyObject *value = PyObject_GetAttr(object, names[name]);
    PyObject *found = value ? PySequence_Tuple(value) : NULL;
    Py_XDECREF(value);
    return found;
}

static int read_attribute(PyObject *object, int name, double *into, Py_ssize_t count) {
    PyObject *value = PyObject_GetAttr(object, names[name]);
    int failed = !value || read_doubles(value, into, count) < 0;
    Py_XDECREF(value);
    return failed ? -1 : 0;
}

static int read_number(PyObject *object, int name, double *into) {
    PyObject *value = PyObject_GetAttr(object, names[name]);
    *into = value ? PyFloat_AsDouble(value) : -1.0;
    Py_XDECREF(value);
    return PyErr_Occurred() ? -1 : 0;
}

static int read_index(PyObject *object, int name, Py_ssize_t least, Py_ssize_t limit, Py_ssize_t *into) {
    PyObject *value = PyObject_GetAttr(object, names[name]);
    *into = value ? PyLong_AsSsize_t(value) : -1;
    Py_XDECREF(value);
    if (PyErr_Occurred()) return -1;
    if (*into >= least && *into < limit) return 0;
    PyErr_SetString(PyExc_IndexError, "a contact or coordinate does not exist");
    return -1;
}

static int read_matrix(PyObject *object, int name, double *into, Py_ssize_t count, Py_ssize_t width) {
    PyObject *rows = sequence_at(object, name);
    int failed = !rows;
    if (rows && PyTuple_GET_SIZE(rows) != count) {
        PyErr_SetString(PyExc_ValueError, "a matrix has another number of rows");
        failed = 1;
    }
    for (Py_ssize_t i = 0; !failed && i < count; i++)
        failed = read_doubles(PyTuple_GET_ITEM(rows, i), into + i * width, width) < 0;
    Py_XDECREF(rows);
    return failed ? -1 : 0;
}

static Py_ssize_t length_of(PyObject *object, int name) {
    PyObject *value = PyObject_GetAttr(object, names[name]);
    Py_ssize_t found = value ? PyObject_Size(value) : -1;
    Py_XDECREF(value);
    return found;
}

static int allocate(Contacts *self) {
    Py_ssize_t n = self->n, c = self->c, rows = self->rows, grips = self->grips, limit = 30000;
    if (n > limit || c > limit || rows > limit || grips > limit) {
        PyErr_SetString(PyExc_ValueError, "the problem is too large");
        return -1;
    }
    Py_ssize_t sizes[] = {n * n, c * n, n, c, rows, rows * n, rows * c, grips * n, n + rows + grips, rows, c, grips};
    double **arrays[] = {&self->mass, &self->lifted, &self->force, &self->press,      &self->targets, &self->along,
                         &self->lift, &self->slips,  &self->x,     &self->multiplier, &self->normal,  &self->friction};
    Py_ssize_t total = 0;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) total += sizes[i];
    self->cells = new_doubles(total);
    self->acting = PyMem_Calloc(2 * (size_t)rows + 1, 1);
    self->grip = PyMem_Calloc((size_t)grips + 1, sizeof(Grip));
    if (!self->cells || !self->acting || !self->grip) {
        PyErr_NoMemory();
        return -1;
    }
    self->held = self->acting + rows;
    double *next = self->cells;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        *arrays[i] = next;
        next += sizes[i];
    }
    return 0;
}

static int read_rows(Contacts *self, PyObject *problem, PyObject *acting) {
    PyObject *rows = sequence_at(problem, ROWS), *held = rows ? sequence_at(problem, HELD) : NULL;
    int failed = !held;
    if (held && (PyTuple_GET_SIZE(rows) != self->rows || PyTuple_GET_SIZE(held) != self->rows ||
                 PyTuple_GET_SIZE(acting) != self->rows)) {
        PyErr_SetString(PyExc_ValueError, "the mode or `held` has another number of rows");
        failed = 1;
    }
    for (Py_ssize_t i = 0; !failed && i < self->rows; i++) {
        PyObject *row = PyTuple_GET_ITEM(rows, i);
        int acts = PyObject_IsTrue(PyTuple_GET_ITEM(acting, i)), holds = PyObject_IsTrue(PyTuple_GET_ITEM(held, i));
        failed = acts < 0 || holds < 0 || read_attribute(row, ALONG, self->along + i * self->n, self->n) < 0 ||
                 read_attribute(row, LIFT, self->lift + i * self->c, self->c) < 0;
        self->acting[i] = acts > 0;
        self->held[i] = holds > 0;
        self->active += acts > 0;
    }
    Py_XDECREF(rows);
    Py_XDECREF(held);
    return failed ? -1 : 0;
}

static int read_grip(Contacts *self, PyObject *object, Py_ssize_t number) {
    Grip *grip = self->grip + number;
    PyObject *slip = PyObject_GetAttr(object, names[SLIP]), *both = NULL;
    double *along = self->slips + number * self->n;
    int failed = !slip || read_attribute(slip, ALONG, along, self->n) < 0 ||
                 read_number(object, FRICTION, &grip->friction) < 0 || read_number(object, HOLDS, &grip->holds) < 0 ||
                 read_index(object, CONTACT, 0, self->c, &grip->contact) < 0 ||
                 read_index(object, COORDINATE, -1, self->n, &grip->coordinate) < 0 ||
                 !(both = PyObject_GetAttr(object, names[BOTH])) || (grip->both = PyObject_IsTrue(both)) < 0;
    grip->along = along;
    Py_XDECREF(slip);
    Py_XDECREF(both);
    return failed ? -1 : 0;
}

static int read_grips(Contacts *self, PyObject *problem, PyObject *rubbing) {
    PyObject *grips = sequence_at(problem, GRIPS), *sliding = grips ? sequence_at(problem, SLIDING) : NULL;
    int failed = !sliding;
    if (sliding && (PyTuple_GET_SIZE(grips) != self->grips || PyTuple_GET_SIZE(sliding) != self->grips ||
                    PyTuple_GET_SIZE(rubbing) != self->grips)) {
        PyErr_SetString(PyExc_ValueError, "the mode or `sliding` has another number of rough contacts");
        failed = 1;
    }
    for (Py_ssize_t i = 0; !failed && i < self->grips; i++) {
        long side = PyLong_AsLong(PyTuple_GET_ITEM(rubbing, i)), slides = PyLong_AsLong(PyTuple_GET_ITEM(sliding, i));
        failed = PyErr_Occurred() || read_grip(self, PyTuple_GET_ITEM(grips, i), i) < 0;
        self->grip[i].side = (side > 0) - (side < 0);
        self->grip[i].sliding = slides != 0;
        self->extra += side == 0 && self->grip[i].coordinate < 0;
    }
    Py_XDECREF(grips);
    Py_XDECREF(sliding);
    return failed ? -1 : 0;
}

static int read_problem(Contacts *self, PyObject *problem, PyObject *acting, PyObject *rubbing) {
    if ((self->n = length_of(problem, FORCE)) < 0 || (self->c = length_of(problem, PRESS)) < 0 ||
        (self->rows = length_of(problem, ROWS)) < 0 || (self->grips = length_of(problem, GRIPS)) < 0)
        return -1;
    return allocate(self) < 0 || read_matrix(problem, MASS, self->mass, self->n, self->n) < 0 ||
                   read_matrix(problem, LIFTED, self->lifted, self->c, self->n) < 0 ||
                   read_attribute(problem, FORCE, self->force, self->n) < 0 ||
                   read_attribute(problem, PRESS, self->press, self->c) < 0 ||
                   read_attribute(problem, TARGETS, self->targets, self->rows) < 0 ||
                   read_number(problem, LOAD, &self->load) < 0 || read_rows(self, problem, acting) < 0 ||
                   read_grips(self, problem, rubbing) < 0
               ? -1
               : 0;
}

/* ---- the equations */

/* Add the kinetic friction −µN of a contact, with N as its own row of the equations of motion gives it. */
static void rub(const Contacts *self, const Grip *grip, System *system) {
    Py_ssize_t n = self->n;
    for (Py_ssize_t k = 0; k < n; k++) {
        if (grip->along[k] == 0.0) continue;
        double weight = grip->friction * grip->side * grip->along[k], *row = system->cells + k * system->width;
        Py_ssize_t column = 0;
        for (; column < n; column++) row[column] = row[column] + weight * self->lifted[grip->contact * n + column];
        for (Py_ssize_t i = 0; i < self->rows; i++)
            if (self->acting[i]) {
                row[column] = row[column] + weight * self->lift[i * self->c + grip->contact];
                column++;
            }
        for (; column < system->size; column++) row[column] = row[column] + weight * 0.0;
        row[column] = row[column] + weight * self->press[grip->contact];
    }
}

/* Set a row to coefficients of accelerations, with zeros for forces. */
static void set_row(System *system, Py_ssize_t at, const double *along, Py_ssize_t n, double right) {
    double *row = system->cells + at * system->width;
    memcpy(row, along, sizeof(double) * (size_t)n);
    for (Py_ssize_t column = n; column < system->size; column++) row[column] = 0.0;
    row[system->size] = right;
}

static void set_equations(const Contacts *self, System *system, double faint) {
    Py_ssize_t n = self->n;
    for (Py_ssize_t k = 0; k < n; k++) {
        double *row = system->cells + k * system->width;
        Py_ssize_t column = n;
        memcpy(row, self->mass + k * n, sizeof(double) * (size_t)n);
        for (Py_ssize_t i = 0; i < self->rows; i++)
            if (self->acting[i]) row[column++] = self->along[i * n + k];
        for (Py_ssize_t i = 0; i < self->grips; i++)
            if (!self->grip[i].side && self->grip[i].coordinate < 0) row[column++] = -self->grip[i].along[k];
        row[column] = self->force[k];
        if (faint != 0.0) row[k] += faint;
    }
    for (Py_ssize_t i = 0; i < self->grips; i++) {
        const Grip *grip = self->grip + i;
        if (grip->side) rub(self, grip, system);
        else if (grip->coordinate >= 0) set_row(system, grip->coordinate, grip->along, n, 0.0);
    }
    Py_ssize_t at = n;
    for (Py_ssize_t i = 0; i < self->rows; i++)
        if (self->acting[i]) set_row(system, at++, self->along + i * n, n, self->targets[i]);
    for (Py_ssize_t i = 0; i < self->grips; i++)
        if (!self->grip[i].side && self->grip[i].coordinate < 0) set_row(system, at++, self->grip[i].along, n, 0.0);
}

/* ---- its forces */

/* Return Σ λ·part over the rows whose multiplier is not zero; `parts` has one entry for each row, `width` apart. */
static double pulled(const Contacts *self, const double *parts, Py_ssize_t width) {
    double total = 0.0;
    for (Py_ssize_t i = 0; i < self->rows; i++)
        if (self->multiplier[i] != 0.0) total += self->multiplier[i] * parts[i * width];
    return total;
}

static void set_forces(Contacts *self) {
    Py_ssize_t n = self->n, next = n;
    const double *x = self->x;
    for (Py_ssize_t i = 0; i < self->rows; i++) self->multiplier[i] = self->acting[i] ? x[next++] : 0.0;
    for (Py_ssize_t i = 0; i < self->c; i++)
        self->normal[i] = dot(self->lifted + i * n, x, n) - self->press[i] + pulled(self, self->lift + i, self->c);
    for (Py_ssize_t i = 0; i < self->grips; i++) {
        const Grip *grip = self->grip + i;
        Py_ssize_t k = grip->coordinate;
        if (grip->side) self->friction[i] = -grip->friction * grip->side * self->normal[grip->contact];
        else if (k < 0) self->friction[i] = x[next++];
        else self->friction[i] = dot(self->mass + k * n, x, n) - self->force[k] + pulled(self, self->along + k, n);
    }
}

static double rate(const double *along, const double *x, Py_ssize_t n) {
    double total = 0.0;
    for (Py_ssize_t k = 0; k < n; k++)
        if (along[k] != 0.0) total += along[k] * x[k];
    return total;
}

static double largest(const double *values, Py_ssize_t count) {
    double found = count ? fabs(values[0]) : 0.0;
    for (Py_ssize_t i = 1; i < count; i++) found = greater(found, fabs(values[i]));
    return found;
}

/* Return whether the mode obeys all its inequalities. */
static int is_obeyed(const Contacts *self) {
    Py_ssize_t n = self->n;
    const double *x = self->x;
    double size = greater(greater(largest(x, n), largest(self->targets, self->rows)), 1.0);
    double small_force = TOLERANCE * greater(self->load, 1e-3), small_x = TOLERANCE * size;
    for (Py_ssize_t i = 0; i < self->rows; i++) {
        if (self->held[i]) continue;
        if (self->acting[i] ? self->multiplier[i] < -small_force
                            : rate(self->along + i * n, x, n) - self->targets[i] > small_x)
            return 0;
    }
    for (Py_ssize_t i = 0; i < self->grips; i++) {
        const Grip *grip = self->grip + i;
        double normal = self->normal[grip->contact];
        if ((isinf(grip->friction) && grip->friction > 0.0) || grip->sliding) continue;
        if (grip->both) normal = fabs(normal);
        if (grip->side ? grip->side * rate(grip->along, x, n) < -small_x
                       : fabs(self->friction[i]) > grip->holds * normal + small_force)
            return 0;
    }
    return 1;
}

static PyObject *told(const Contacts *self, const System *system) {
    PyObject *parts[5] = {list_of(self->x, system->size), system_nulls(system),
                          list_of(self->multiplier, self->rows), list_of(self->friction, self->grips),
                          list_of(self->normal, self->c)};
    for (int i = 0; i < 5; i++)
        if (!parts[i]) {
            for (int k = 0; k < 5; k++) Py_XDECREF(parts[k]);
            return NULL;
        }
    return Py_BuildValue("(NNO(NNN)O)", parts[0], parts[1], system->consistent ? Py_True : Py_False, parts[2], parts[3],
                         parts[4], is_obeyed(self) ? Py_True : Py_False);
}

/* evaluate_mode(problem, acting, rubbing, faint): return the solution of the equations, their null vectors, whether they
 * are consistent, the forces (rows, friction, normal), and whether these obey the inequalities of the mode. */
PyObject *evaluate_mode(PyObject *module, PyObject *arguments) {
    Contacts self = {0};
    System system = {0};
    PyObject *problem, *acting, *rubbing, *found = NULL;
    double faint;
    (void)module;
    if (!PyArg_ParseTuple(arguments, "OO!O!d", &problem, &PyTuple_Type, &acting, &PyTuple_Type, &rubbing, &faint))
        return NULL;
    if (read_problem(&self, problem, acting, rubbing) == 0) {
        Py_ssize_t size = self.n + self.active + self.extra;
        if (system_allocate(&system, size, size) == 0) {
            set_equations(&self, &system, faint);
            system_solve(&system);
            memcpy(self.x, system.x, sizeof(double) * (size_t)size);
            set_forces(&self);
            found = told(&self, &system);
        }
    }
    system_free(&system);
    PyMem_Free(self.cells);
    PyMem_Free(self.acting);
    PyMem_Free(self.grip);
    return found;
}
