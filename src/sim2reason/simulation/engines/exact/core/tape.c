/* The record of arithmetic on symbols; see tape.py, whose classes these replace. */
#include "core.h"

PyTypeObject *TapeType, *SymbolType;

static const char *const NAMES[OPERATIONS] = {"input", "constant", "+", "-", "*", "/", "neg", "sqrt", "sin", "cos"};
#define MOST_NODES (INT32_MAX / 4)

/* ---- nodes */

static Fault value_of_node(const Tape *tape, Node node, double *value) {
    double a = node.operation > CONSTANT ? tape->values[node.a] : 0.0;
    double b = node.b >= 0 ? tape->values[node.b] : 0.0;
    switch (node.operation) {
    case INPUT: /* before `stand` it has no value; afterwards no input is recorded */
        *value = 0.0;
        return OK;
    case CONSTANT:
        *value = tape->constants[node.a];
        return OK;
    case ADD:
        *value = a + b;
        return OK;
    case SUBTRACT:
        *value = a - b;
        return OK;
    case MULTIPLY:
        *value = a * b;
        return OK;
    case DIVIDE:
        *value = b != 0.0 ? a / b : Py_NAN;
        return OK;
    case NEGATE:
        *value = -a;
        return OK;
    case SQRT:
        *value = a >= 0.0 ? sqrt(a) : Py_NAN;
        return OK;
    default:
        if (isinf(a)) return DOMAIN_FAULT;
        *value = node.operation == SIN ? sin(a) : cos(a);
        return OK;
    }
}

static uint64_t mixed(uint64_t x) {
    x ^= x >> 31;
    x *= 0x9E3779B97F4A7C15u;
    return x ^ (x >> 29);
}

static uint64_t hash_of(Node node) {
    return mixed(((uint64_t)(uint32_t)node.a << 32 | (uint32_t)node.b) * 31u + (uint64_t)node.operation);
}

static uint64_t hash_of_number(double number) {
    uint64_t bits;
    if (number == 0.0) number = 0.0; /* both zeros are one constant, as in a dict */
    memcpy(&bits, &number, sizeof bits);
    return mixed(bits);
}

static int32_t *free_slots(Py_ssize_t count) {
    int32_t *found = PyMem_Malloc(sizeof(int32_t) * (size_t)count);
    if (!found) PyErr_NoMemory();
    else memset(found, 0xff, sizeof(int32_t) * (size_t)count);
    return found;
}

static int rehash_nodes(Tape *tape) {
    Py_ssize_t count = tape->slot_count * 2;
    int32_t *slots = free_slots(count);
    if (!slots) return -1;
    for (int32_t number = 0; number < tape->count; number++) {
        size_t at = (size_t)hash_of(tape->nodes[number]) & (size_t)(count - 1);
        while (slots[at] >= 0) at = (at + 1) & (size_t)(count - 1);
        slots[at] = number;
    }
    PyMem_Free(tape->slots);
    tape->slots = slots;
    tape->slot_count = count;
    return 0;
}

static int rehash_constants(Tape *tape) {
    Py_ssize_t count = tape->constant_slot_count * 2;
    int32_t *slots = free_slots(count);
    if (!slots) return -1;
    for (int32_t number = 0; number < tape->constant_count; number++) {
        size_t at = (size_t)hash_of_number(tape->constants[number]) & (size_t)(count - 1);
        while (slots[at] >= 0) at = (at + 1) & (size_t)(count - 1);
        slots[at] = number;
    }
    PyMem_Free(tape->constant_slots);
    tape->constant_slots = slots;
    tape->constant_slot_count = count;
    return 0;
}

/* Return the index of a node, recorded if it is new; -1 and an exception if that fails. */
static int32_t node_id(Tape *tape, int32_t operation, int32_t a, int32_t b) {
    Node node = {operation, a, b};
    size_t mask = (size_t)tape->slot_count - 1, at = (size_t)hash_of(node) & mask;
    for (; tape->slots[at] >= 0; at = (at + 1) & mask) {
        const Node *known = tape->nodes + tape->slots[at];
        if (known->operation == operation && known->a == a && known->b == b) return tape->slots[at];
    }
    if (tape->count >= MOST_NODES) {
        PyErr_NoMemory();
        return -1;
    }
    if (grown((void **)&tape->nodes, &tape->node_room, tape->count + 1, sizeof(Node)) < 0 ||
        grown((void **)&tape->values, &tape->value_room, tape->count + 1, sizeof(double)) < 0)
        return -1;
    double value = 0.0;
    if (tape->stands) {
        Fault fault = value_of_node(tape, node, &value);
        if (fault) {
            raise_fault(fault);
            return -1;
        }
    }
    int32_t number = (int32_t)tape->count;
    if (2 * (tape->count + 1) > tape->slot_count && rehash_nodes(tape) < 0) return -1;
    mask = (size_t)tape->slot_count - 1;
    for (at = (size_t)hash_of(node) & mask; tape->slots[at] >= 0;) at = (at + 1) & mask;
    tape->nodes[number] = node;
    tape->values[number] = value;
    tape->slots[at] = number;
    tape->count++;
    return number;
}

static int32_t constant_id(Tape *tape, double number) {
    size_t mask = (size_t)tape->constant_slot_count - 1, at = (size_t)hash_of_number(number) & mask;
    for (; tape->constant_slots[at] >= 0; at = (at + 1) & mask)
        if (tape->constants[tape->constant_slots[at]] == number)
            return node_id(tape, CONSTANT, tape->constant_slots[at], -1);
    if (tape->constant_count >= MOST_NODES) {
        PyErr_NoMemory();
        return -1;
    }
    if (grown((void **)&tape->constants, &tape->constant_room, tape->constant_count + 1, sizeof(double)) < 0) return -1;
    if (2 * (tape->constant_count + 1) > tape->constant_slot_count && rehash_constants(tape) < 0) return -1;
    mask = (size_t)tape->constant_slot_count - 1;
    for (at = (size_t)hash_of_number(number) & mask; tape->constant_slots[at] >= 0;) at = (at + 1) & mask;
    int32_t index = (int32_t)tape->constant_count;
    tape->constants[index] = number;
    tape->constant_slots[at] = index;
    tape->constant_count++;
    return node_id(tape, CONSTANT, index, -1);
}

/* Return the node of a symbol of the tape, or of a number, which becomes a constant. */
static int32_t id_of(Tape *tape, PyObject *number) {
    if (PyFloat_CheckExact(number)) return constant_id(tape, PyFloat_AS_DOUBLE(number));
    if (Py_TYPE(number) == SymbolType) {
        if (((Symbol *)number)->tape == tape) return ((Symbol *)number)->id;
        PyErr_SetString(PyExc_ValueError, "the symbol belongs to another tape");
        return -1;
    }
    PyObject *real = PyNumber_Float(number);
    if (!real) return -1;
    int32_t found = constant_id(tape, PyFloat_AS_DOUBLE(real));
    Py_DECREF(real);
    return found;
}

static PyObject *symbol_of(Tape *tape, int32_t id) {
    if (id < 0) return NULL;
    Symbol *found = PyObject_New(Symbol, SymbolType);
    if (!found) return NULL;
    Py_INCREF(tape);
    found->tape = tape;
    found->id = id;
    return (PyObject *)found;
}

/* ---- symbols */

static int is_float(PyObject *number, double value) {
    return PyFloat_CheckExact(number) && PyFloat_AS_DOUBLE(number) == value;
}

static Tape *tape_of(PyObject *one, PyObject *other) {
    return Py_TYPE(one) == SymbolType ? ((Symbol *)one)->tape : ((Symbol *)other)->tape;
}

static PyObject *binary(Tape *tape, int32_t operation, PyObject *one, PyObject *other) {
    int32_t a = id_of(tape, one), b = a < 0 ? -1 : id_of(tape, other);
    if (b < 0) return NULL;
    if ((operation == ADD || operation == MULTIPLY) && b < a) {
        int32_t first = b;
        b = a;
        a = first;
    }
    return symbol_of(tape, node_id(tape, operation, a, b));
}

static PyObject *symbol_negative(PyObject *self) {
    Symbol *symbol = (Symbol *)self;
    return symbol_of(symbol->tape, node_id(symbol->tape, NEGATE, symbol->id, -1));
}

static PyObject *symbol_add(PyObject *one, PyObject *other) {
    if (is_float(other, 0.0)) return Py_NewRef(one);
    if (is_float(one, 0.0)) return Py_NewRef(other);
    return binary(tape_of(one, other), ADD, one, other);
}

static PyObject *symbol_subtract(PyObject *one, PyObject *other) {
    if (is_float(other, 0.0)) return Py_NewRef(one);
    if (is_float(one, 0.0)) return symbol_negative(other);
    return binary(tape_of(one, other), SUBTRACT, one, other);
}

static PyObject *symbol_multiply(PyObject *one, PyObject *other) {
    PyObject *symbol = Py_TYPE(one) == SymbolType ? one : other, *factor = symbol == one ? other : one;
    if (PyFloat_CheckExact(factor)) {
        double value = PyFloat_AS_DOUBLE(factor);
        if (value == 0.0) return PyFloat_FromDouble(0.0);
        if (value == 1.0) return Py_NewRef(symbol);
        if (value == -1.0) return symbol_negative(symbol);
    }
    return binary(((Symbol *)symbol)->tape, MULTIPLY, symbol, factor);
}

static PyObject *symbol_divide(PyObject *one, PyObject *other) {
    if (is_float(other, 1.0)) return Py_NewRef(one);
    if (is_float(one, 0.0)) return PyFloat_FromDouble(0.0);
    return binary(tape_of(one, other), DIVIDE, one, other);
}

static PyObject *symbol_new(PyTypeObject *type, PyObject *arguments, PyObject *keywords) {
    static char *names[] = {"tape", "number", NULL};
    Tape *tape;
    int id;
    (void)type;
    if (!PyArg_ParseTupleAndKeywords(arguments, keywords, "O!i", names, TapeType, &tape, &id)) return NULL;
    if (id < 0 || id >= tape->count) {
        PyErr_SetString(PyExc_IndexError, "the tape has no such node");
        return NULL;
    }
    return symbol_of(tape, id);
}

static void symbol_free(PyObject *self) {
    PyTypeObject *type = Py_TYPE(self);
    Py_XDECREF(((Symbol *)self)->tape);
    PyObject_Free(self);
    Py_DECREF(type);
}

static PyObject *symbol_id(PyObject *self, void *unused) {
    (void)unused;
    return PyLong_FromLong(((Symbol *)self)->id);
}

static PyObject *symbol_tape(PyObject *self, void *unused) {
    (void)unused;
    return Py_NewRef(((Symbol *)self)->tape);
}

static PyObject *symbol_value(PyObject *self, void *unused) {
    (void)unused;
    return PyFloat_FromDouble(((Symbol *)self)->tape->values[((Symbol *)self)->id]);
}

static PyGetSetDef symbol_attributes[] = {
    {"id", symbol_id, NULL, NULL, NULL},
    {"tape", symbol_tape, NULL, NULL, NULL},
    {"value", symbol_value, NULL, "The value at the inputs that `Tape.stand` received last.", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};

static PyType_Slot symbol_slots[] = {
    {Py_tp_doc, "A number whose value is known only when the program runs."},
    {Py_tp_new, symbol_new},
    {Py_tp_dealloc, symbol_free},
    {Py_tp_getset, symbol_attributes},
    {Py_nb_add, symbol_add},
    {Py_nb_subtract, symbol_subtract},
    {Py_nb_multiply, symbol_multiply},
    {Py_nb_true_divide, symbol_divide},
    {Py_nb_negative, symbol_negative},
    {0, NULL},
};

static PyType_Spec symbol_spec = {
    "sim2reason.simulation.engines.exact.core._core.Symbol", sizeof(Symbol), 0, Py_TPFLAGS_DEFAULT, symbol_slots,
};

/* ---- the tape */

static void tape_free(PyObject *self) {
    Tape *tape = (Tape *)self;
    PyTypeObject *type = Py_TYPE(self);
    PyMem_Free(tape->nodes);
    PyMem_Free(tape->values);
    PyMem_Free(tape->constants);
    PyMem_Free(tape->slots);
    PyMem_Free(tape->constant_slots);
    Py_XDECREF(tape->names);
    Py_XDECREF(tape->node_list);
    Py_XDECREF(tape->constant_list);
    type->tp_free(self);
    Py_DECREF(type);
}

static PyObject *tape_new(PyTypeObject *type, PyObject *arguments, PyObject *keywords) {
    static char *names[] = {"inputs", NULL};
    PyObject *inputs;
    if (!PyArg_ParseTupleAndKeywords(arguments, keywords, "O", names, &inputs)) return NULL;
    Tape *tape = (Tape *)type->tp_alloc(type, 0);
    if (!tape) return NULL;
    tape->slot_count = 64;
    tape->constant_slot_count = 32;
    tape->slots = free_slots(tape->slot_count);
    tape->constant_slots = free_slots(tape->constant_slot_count);
    tape->names = PySequence_List(inputs);
    tape->node_list = PyList_New(0);
    tape->constant_list = PyList_New(0);
    if (!tape->slots || !tape->constant_slots || !tape->names || !tape->node_list || !tape->constant_list) goto failed;
    tape->inputs = PyList_GET_SIZE(tape->names);
    if (!tape->inputs || tape->inputs > MOST_NODES) {
        PyErr_SetString(PyExc_ValueError, "a tape has at least one input");
        goto failed;
    }
    for (Py_ssize_t i = 0; i < tape->inputs; i++)
        if (node_id(tape, INPUT, (int32_t)i, -1) < 0) goto failed;
    return (PyObject *)tape;
failed:
    Py_DECREF(tape);
    return NULL;
}

static PyObject *tape_inputs(PyObject *self, void *unused) {
    Tape *tape = (Tape *)self;
    PyObject *found = PyDict_New();
    (void)unused;
    for (Py_ssize_t i = 0; found && i < tape->inputs && i < PyList_GET_SIZE(tape->names); i++) {
        PyObject *symbol = symbol_of(tape, (int32_t)i);
        if (!symbol || PyDict_SetItem(found, PyList_GET_ITEM(tape->names, i), symbol) < 0) Py_CLEAR(found);
        Py_XDECREF(symbol);
    }
    return found;
}

static PyObject *tape_nodes(PyObject *self, void *unused) {
    Tape *tape = (Tape *)self;
    (void)unused;
    while (PyList_GET_SIZE(tape->node_list) < tape->count) {
        const Node *node = tape->nodes + PyList_GET_SIZE(tape->node_list);
        PyObject *item = Py_BuildValue("(sii)", NAMES[node->operation], node->a, node->b);
        int failed = !item || PyList_Append(tape->node_list, item) < 0;
        Py_XDECREF(item);
        if (failed) return NULL;
    }
    return Py_NewRef(tape->node_list);
}

static PyObject *tape_constants(PyObject *self, void *unused) {
    Tape *tape = (Tape *)self;
    (void)unused;
    while (PyList_GET_SIZE(tape->constant_list) < tape->constant_count) {
        PyObject *item = PyFloat_FromDouble(tape->constants[PyList_GET_SIZE(tape->constant_list)]);
        int failed = !item || PyList_Append(tape->constant_list, item) < 0;
        Py_XDECREF(item);
        if (failed) return NULL;
    }
    return Py_NewRef(tape->constant_list);
}

static PyObject *tape_names(PyObject *self, void *unused) {
    (void)unused;
    return Py_NewRef(((Tape *)self)->names);
}

static PyObject *tape_written(PyObject *self, void *unused) {
    (void)unused;
    return PyLong_FromSsize_t(((Tape *)self)->written);
}

static PyObject *tape_stand(PyObject *self, PyObject *inputs) {
    Tape *tape = (Tape *)self;
    if (read_doubles(inputs, tape->values, tape->inputs) < 0) return NULL;
    tape->stands = 1;
    for (Py_ssize_t number = tape->inputs; number < tape->count; number++) {
        Fault fault = value_of_node(tape, tape->nodes[number], tape->values + number);
        if (fault) {
            raise_fault(fault);
            return NULL;
        }
    }
    Py_RETURN_NONE;
}

/* Return the symbol of a function, or its value if the argument is a number. */
static PyObject *function_of(PyObject *self, PyObject *argument, int32_t operation) {
    if (Py_TYPE(argument) == SymbolType) {
        Symbol *symbol = (Symbol *)argument;
        if (symbol->tape != (Tape *)self) {
            PyErr_SetString(PyExc_ValueError, "the symbol belongs to another tape");
            return NULL;
        }
        return symbol_of(symbol->tape, node_id(symbol->tape, operation, symbol->id, -1));
    }
    double x = PyFloat_AsDouble(argument);
    if (x == -1.0 && PyErr_Occurred()) return NULL;
    if (operation == SQRT ? x < 0.0 : isinf(x)) {
        raise_fault(DOMAIN_FAULT);
        return NULL;
    }
    return PyFloat_FromDouble(operation == SQRT ? sqrt(x) : operation == SIN ? sin(x) : cos(x));
}

static PyObject *tape_sqrt(PyObject *self, PyObject *x) { return function_of(self, x, SQRT); }
static PyObject *tape_sin(PyObject *self, PyObject *x) { return function_of(self, x, SIN); }
static PyObject *tape_cos(PyObject *self, PyObject *x) { return function_of(self, x, COS); }

static PyObject *tape_program(PyObject *self, PyObject *arguments) {
    PyObject *outputs, *guards;
    if (!PyArg_ParseTuple(arguments, "OO", &outputs, &guards)) return NULL;
    return program_of((Tape *)self, outputs, guards);
}

static PyMethodDef tape_methods[] = {
    {"stand", tape_stand, METH_O, "Evaluate every symbol for given inputs; a symbol without a value becomes NaN."},
    {"sqrt", tape_sqrt, METH_O, "Return the square root of a number or symbol."},
    {"sin", tape_sin, METH_O, "Return the sine of a number or symbol."},
    {"cos", tape_cos, METH_O, "Return the cosine of a number or symbol."},
    {"program", tape_program, METH_VARARGS, "Return the program of outputs, guarded by pairs of symbol and bound."},
    {NULL, NULL, 0, NULL},
};

static PyGetSetDef tape_attributes[] = {
    {"inputs", tape_inputs, NULL, "The input symbols by name.", NULL},
    {"names", tape_names, NULL, NULL, NULL},
    {"nodes", tape_nodes, NULL, "All recorded operations, as (operation, a, b); not to be changed.", NULL},
    {"constants", tape_constants, NULL, NULL, NULL},
    {"written", tape_written, NULL, "The number of operations of the program that was made last.", NULL},
    {NULL, NULL, NULL, NULL, NULL},
};

static PyType_Slot tape_slots[] = {
    {Py_tp_doc, "A record of arithmetic operations, which also provides the elementary functions of its symbols."},
    {Py_tp_new, tape_new},
    {Py_tp_dealloc, tape_free},
    {Py_tp_methods, tape_methods},
    {Py_tp_getset, tape_attributes},
    {0, NULL},
};

static PyType_Spec tape_spec = {
    "sim2reason.simulation.engines.exact.core._core.Tape", sizeof(Tape), 0, Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE,
    tape_slots,
};

int add_tape_types(PyObject *module) {
    TapeType = (PyTypeObject *)PyType_FromSpec(&tape_spec);
    SymbolType = (PyTypeObject *)PyType_FromSpec(&symbol_spec);
    if (!TapeType || !SymbolType) return -1;
    return PyModule_AddObjectRef(module, "Tape", (PyObject *)TapeType) < 0 ||
                   PyModule_AddObjectRef(module, "Symbol", (PyObject *)SymbolType) < 0
               ? -1
               : 0;
}
