/* The native core of the exact engine: the same operations in the same order as the Python modules beside it.
 *
 * Results are bit for bit those of Python. Compile without contraction to fused operations and without built-in
 * versions of the functions of libm (-ffp-contract=off -fno-builtin), and never with -ffast-math.
 */
#ifndef SIM2REASON_CORE_H
#define SIM2REASON_CORE_H

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "results would not be those of Python: arithmetic has excess precision"
#endif

/* ---- faults: why arithmetic has no result, each the exception that Python raises */

typedef enum { OK, ZERO_DIVISION, DOMAIN_FAULT, OVERFLOW_FAULT, PIVOT_LOST, NO_MEMORY } Fault;

/* Set the exception of a fault. */
void raise_fault(Fault fault);

/* ---- memory */

#define MOST (PY_SSIZE_T_MAX / 64) /* more elements than this are refused before any size is computed */

/* Return an uninitialized array of `count` doubles, at least one; NULL and MemoryError if there is no memory. */
double *new_doubles(Py_ssize_t count);

/* Enlarge an array to at least `needed` elements of `size` bytes; -1 and MemoryError if there is no memory. */
int grown(void **array, Py_ssize_t *capacity, Py_ssize_t needed, size_t size);

/* ---- numbers of Python */

/* Read a sequence of exactly `count` numbers; -1 and an exception otherwise. */
int read_doubles(PyObject *sequence, double *into, Py_ssize_t count);

/* Return a tuple of floats. */
PyObject *tuple_of(const double *values, Py_ssize_t count);

/* Return a list of floats. */
PyObject *list_of(const double *values, Py_ssize_t count);

/* Get a C-contiguous buffer of exactly `count` doubles; -1 and an exception otherwise. */
int get_doubles(PyObject *object, Py_buffer *view, Py_ssize_t count, int writable);

/* Return the greater of two as Python's max does: the first unless the second is greater. */
static inline double greater(double one, double other) { return other > one ? other : one; }

/* Return the lesser of two as Python's min does: the first unless the second is less. */
static inline double lesser(double one, double other) { return other < one ? other : one; }

/* ---- tape.c: the record of arithmetic */

enum { INPUT, CONSTANT, ADD, SUBTRACT, MULTIPLY, DIVIDE, NEGATE, SQRT, SIN, COS, OPERATIONS };

typedef struct {
    int32_t operation, a, b; /* operands are earlier nodes; of an input or constant, `a` is its index */
} Node;

typedef struct {
    PyObject_HEAD
    Node *nodes;
    double *values; /* of each node, at the inputs that `stand` received last */
    Py_ssize_t count, node_room, value_room;
    double *constants;
    Py_ssize_t constant_count, constant_room;
    int32_t *slots, *constant_slots; /* hash tables of nodes and of constants, by index; -1 is free */
    Py_ssize_t slot_count, constant_slot_count;
    Py_ssize_t inputs, written;
    int stands;
    PyObject *names, *node_list, *constant_list; /* the latter two as Python reads them, extended on demand */
} Tape;

typedef struct {
    PyObject_HEAD
    Tape *tape;
    int32_t id;
} Symbol;

extern PyTypeObject *TapeType, *SymbolType;
int add_tape_types(PyObject *module);

/* ---- program.c: the compiled form of a tape's outputs */

typedef struct {
    int32_t operation, a, b, into; /* registers */
} Instruction;

typedef struct {
    PyObject_HEAD
    Py_ssize_t inputs, instructions, outputs, guards, registers;
    Instruction *code;
    double *cells; /* the registers: inputs, then constants, then results */
    int32_t *output, *guard;
    double *bound; /* of each guard */
} Program;

extern PyTypeObject *ProgramType;
int add_program_type(PyObject *module);

/* Run a program at a time and at the other inputs; its results are in the registers. */
Fault program_run(Program *program, double time, const double *values);

/* Run a program and copy its outputs. */
Fault program_outputs(Program *program, double time, const double *values, double *into);

/* Return the program of outputs (symbols of a tape or numbers) and guards (pairs of symbol and bound). */
PyObject *program_of(Tape *tape, PyObject *outputs, PyObject *guards);

/* ---- dop853.c: one step */

#define STAGES 16       /* evaluations of a step, three of them for dense output alone */
#define COEFFICIENTS 7  /* of the polynomial of each unknown */
#define LAST 12         /* the stage at the end of the step */

typedef struct {
    double time, length;
    double *values, *end, *rates, *polynomial; /* (n), (n), (STAGES - 3, n) and (n, COEFFICIENTS) */
    int *dense;                                /* whether the polynomial is known */
} Step;

/* Check the API and store the coefficients of the method: nodes, stages, both error estimates and dense output. */
PyObject *set_up(PyObject *module, PyObject *arguments);
int has_coefficients(void);

/* Attempt a step; `step` has its time, length, values and first rates. `room` has space for (STAGES, n) doubles. */
Fault step_attempt(Step *step, Program *rate, Py_ssize_t n, const double *tolerance, double *room, double *error);

/* Compute the polynomial of a step unless it is known. */
Fault step_dense(Step *step, Program *rate, Py_ssize_t n, double *room);

/* Return one unknown at a fraction x of a step. */
double step_at(double start, const double *coefficients, double x);

/* Return the ratio of the next step size to this one. */
double step_factor(double error);

/* Compute the size of the first step. */
Fault first_step(Program *rate, double time, const double *values, const double *first, Py_ssize_t n,
                 const double *tolerance, double *room, double *length);

/* Compute the size of a small motion. */
Fault motion_scale(Program *rate, double time, const double *values, const double *first, Py_ssize_t n, double *room,
                   double *scale);

/* ---- events.c: zeros of event functions within a step */

/* An event function of the fraction of a step, with its context. */
typedef Fault (*Function)(void *context, double x, double *value);

typedef struct {
    Py_ssize_t number;
    double low, high, room;
} Crossing;

/* Find a root between `low`, where the function is positive, and `high`, where it is not. */
Fault bracketed_root(Function function, void *context, double low, double high, double *root);

/* Find the first zero of an event function with values at 0, 1/2 and 1; `found` says whether there is one. */
Fault first_crossing(Function function, void *context, const double *values, int armed, double room,
                     Crossing *crossing, int *found);

extern const double ARMED;

/* ---- linear.c: small systems that may be singular */

/* `count` rows of `size` coefficients, the right side and its scale, with the solution and the free unknowns. */
typedef struct {
    Py_ssize_t size, count, width, pivots, frees;
    double *cells, *x;
    Py_ssize_t *pivot_row, *pivot_column, *free;
    char *used;
    int consistent;
} System;

/* Allocate a system; -1 and an exception if that fails. In any case it is to be freed. */
int system_allocate(System *system, Py_ssize_t count, Py_ssize_t size);
void system_free(System *system);

/* Solve a system whose rows (coefficients, then the right side) are set. */
void system_solve(System *system);

/* Return the null vectors of a solved system. */
PyObject *system_nulls(const System *system);

double dot(const double *one, const double *other, Py_ssize_t count);

/* ---- what Python calls beside methods */

int add_integration_type(PyObject *module);
PyObject *sample_segments(PyObject *module, PyObject *arguments);
PyObject *solve(PyObject *module, PyObject *rows);
PyObject *solve_symbols(PyObject *module, PyObject *equations);
PyObject *evaluate_mode(PyObject *module, PyObject *arguments);
int intern_names(void);

#endif
