/* Zeros of event functions within a step; see crossings.py. */
#include "core.h"

const double ARMED = 1e-9;
#define TANGENTS 12
#define EDGE 0.05
#define SLOPE_STEP 1e-6
#define HALVES 12
#define MAX_ROOT_ITERATIONS 200
#define BISECTION_PATIENCE 4
#define EPSILON 2.3e-16

typedef struct {
    double x, value;
} Sample;

static Fault slope(Function function, void *context, Sample at, double step, double *found) {
    double value;
    Fault fault = function(context, at.x + step, &value);
    *found = (value - at.value) / step;
    return fault;
}

/* Find a point between two samples at which an event function is negative, by tangents. */
static Fault dip(Function function, void *context, Sample low, Sample high, Sample *point, int *found) {
    double falls, rises, steepness;
    Fault fault = slope(function, context, low, SLOPE_STEP, &falls);
    if (fault || (fault = slope(function, context, high, -SLOPE_STEP, &rises))) return fault;
    *found = 0;
    for (int turn = 0; turn < TANGENTS; turn++) {
        if (!(falls < 0.0 && 0.0 < rises)) return OK;
        double steeper = rises - falls;
        if (steeper == 0.0) return ZERO_DIVISION;
        double meet = (low.value - high.value + rises * high.x - falls * low.x) / steeper;
        if (low.value + falls * (meet - low.x) > 0.0 || !(low.x < meet && meet < high.x)) return OK;
        double width = EDGE * (high.x - low.x);
        Sample here = {lesser(greater(meet, low.x + width), high.x - width), 0.0};
        if ((fault = function(context, here.x, &here.value))) return fault;
        if (here.value < 0.0) {
            *point = here;
            *found = 1;
            return OK;
        }
        if ((fault = slope(function, context, here, SLOPE_STEP, &steepness))) return fault;
        if (steepness < 0.0) {
            low = here;
            falls = steepness;
        } else {
            high = here;
            rises = steepness;
        }
    }
    return OK;
}

/* Find where an event function that starts at zero is positive before it is negative. */
static Fault rise(Function function, void *context, const Sample *samples, int count, Sample *point, int *found) {
    double x = 0.0;
    *found = 0;
    for (int i = count - 1; i >= 0; i--)
        if (samples[i].value < 0.0) x = samples[i].x;
    for (int turn = 0; turn < HALVES; turn++) {
        x *= 0.5;
        double value;
        Fault fault = function(context, x, &value);
        if (fault) return fault;
        if (value > ARMED) {
            *point = (Sample){x, value};
            *found = 1;
            return OK;
        }
    }
    return OK;
}

/* Insert a sample where it belongs, by x and then by value. */
static int inserted(Sample *samples, int count, Sample sample) {
    int at = count;
    while (at > 0 && (sample.x < samples[at - 1].x ||
                      (sample.x == samples[at - 1].x && sample.value < samples[at - 1].value))) {
        samples[at] = samples[at - 1];
        at--;
    }
    samples[at] = sample;
    return count + 1;
}

Fault first_crossing(Function function, void *context, const double *values, int armed, double room,
                     Crossing *crossing, int *found) {
    Sample samples[5] = {{0.0, values[0]}, {0.5, values[1]}, {1.0, values[2]}}, points[2];
    int count = 3, extra[2] = {0, 0};
    double least = lesser(lesser(values[0], values[1]), values[2]);
    *found = 0;
    if (least >= 0.0) {
        for (int i = 0; i < 2; i++) {
            Fault fault = dip(function, context, samples[i], samples[i + 1], points + i, extra + i);
            if (fault) return fault;
        }
    } else if (!armed) {
        Fault fault = rise(function, context, samples, 3, points, extra);
        if (fault) return fault;
    }
    for (int i = 0; i < 2; i++)
        if (extra[i]) count = inserted(samples, count, points[i]);
    double last = 0.0;
    for (int i = 0; i < count; i++) {
        if (armed ? samples[i].value < 0.0 : samples[i].value < -room) {
            crossing->low = last;
            crossing->high = samples[i].x;
            crossing->room = armed ? 0.0 : room;
            *found = 1;
            return OK;
        }
        armed = armed || samples[i].value > ARMED;
        last = samples[i].x;
    }
    return OK;
}

Fault bracketed_root(Function function, void *context, double low, double high, double *root) {
    double above, below, value, width = high - low;
    int side = 0;
    Fault fault;
    *root = low;
    if (low == high) return OK;
    if ((fault = function(context, low, &above)) || (fault = function(context, high, &below))) return fault;
    if (above <= 0.0) return OK;
    for (int number = 0; number < MAX_ROOT_ITERATIONS; number++) {
        if (below - above == 0.0) return ZERO_DIVISION;
        double middle = (low * below - high * above) / (below - above);
        int turn = number % BISECTION_PATIENCE == BISECTION_PATIENCE - 1;
        if ((turn && high - low > 0.5 * width) || !(low < middle && middle < high)) middle = 0.5 * (low + high);
        if (turn) width = high - low;
        if ((fault = function(context, middle, &value))) return fault;
        if (value > 0.0) {
            low = middle;
            above = value;
            if (side == 1) below = 0.5 * below;
            side = 1;
        } else {
            high = middle;
            below = value;
            if (side == -1) above = 0.5 * above;
            side = -1;
        }
        if (value == 0.0 || high - low <= 4.0 * EPSILON * greater(fabs(low), fabs(high))) break;
    }
    *root = high;
    return OK;
}
