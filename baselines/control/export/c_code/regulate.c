
/* Voltages, not yet saturated, on the prediction for when they take effect. */
static void regulate(int k, const real x[6], const real rotors[2], real u[2]) {
    real x_ref[6], v_hold[2], v[2], deviation[GAINS];
    int n = 6;
    for (int i = 0; i < 6; i++) {
        x_ref[i] = STATE[k][i];
    }
    v_hold[0] = HOLD[k][0];
    v_hold[1] = HOLD[k][1];
#if OBSERVING
    accommodate(x_ref, v_hold);
#endif
    for (int i = 0; i < 6; i++) {
        deviation[i] = x[i] - x_ref[i];
    }
#if LAGGING
    virtual_input(rotors, v);
    deviation[n++] = v[0] - v_hold[0];
    deviation[n++] = v[1] - v_hold[1];
#else
    (void)rotors;
#endif
#if INTEGRATING
    deviation[n++] = memory.integral[0];
    deviation[n++] = memory.integral[1];
#endif
    for (int i = 0; i < 2; i++) {
        v[i] = FEEDFORWARD[k][i] + (v_hold[i] - HOLD[k][i]);
        for (int j = 0; j < n; j++) {
            v[i] -= GAIN[k][GAINS * i + j] * deviation[j];
        }
    }
    u[0] = front_voltage(REAL(0.5) * (v[0] + v[1]));
    u[1] = back_voltage(REAL(0.5) * (v[0] - v[1]));
}

static void base_reset(void) {
    memory.started = 0;
}

static void start(int now) {
    memory.started = 1;
    memory.start = now;
    for (int i = 0; i < 6; i++) {
        memory.x[i] = STATE[now][i];
        memory.carry[i] = REAL(0.0);
    }
    for (int i = 0; i < 3; i++) {
        memory.disturbance[i] = REAL(0.0);
    }
    for (int i = 0; i < 2; i++) {
        memory.rotors[i] = VOLTAGE[now][i];
        memory.integral[i] = REAL(0.0);
        for (int k = 0; k <= DELAY; k++) {
            memory.pending[k][i] = VOLTAGE[now][i];
        }
    }
}

/* The voltages before saturation; memory.pending[DELAY] is where the command goes. */
static void base_control(real t, const real y[6], real u[2]) {
    const int now = index_of(t);
    const int arrival = now + DELAY < LAST ? now + DELAY : LAST;
    real later[6], rotors[2];
    if (!memory.started) {
        start(now);
    }
#if OBSERVING
    {
        /* a flight that begins later settles as one from the start does */
        const int since = now - memory.start;
        const int k = memory.start > 0 && since < SETTLING ? since : now;
        real innovation[3], correction[9];
        for (int j = 0; j < 3; j++) {
            innovation[j] = (y[2 * j] - memory.x[2 * j]) - memory.carry[2 * j];
        }
        for (int i = 0; i < 9; i++) {
            correction[i] = REAL(0.0);
            for (int j = 0; j < 3; j++) {
                correction[i] += OBSERVER[k][3 * i + j] * innovation[j];
            }
        }
        for (int i = 0; i < 6; i++) {
            add(i, correction[i]);
        }
        for (int i = 0; i < 3; i++) {
            memory.disturbance[i] += correction[6 + i];
        }
    }
#else
    for (int i = 0; i < 6; i++) {
        memory.x[i] = y[i];
        memory.carry[i] = REAL(0.0);
    }
#endif
    for (int i = 0; i < 6; i++) {
        later[i] = memory.x[i];
    }
    rotors[0] = memory.rotors[0];
    rotors[1] = memory.rotors[1];
#if DELAY
    for (int first = 0; first < DELAY; first += STRETCH) {
        const int count = DELAY - first < STRETCH ? DELAY - first : STRETCH;
        real change[6], mean[2] = {REAL(0.0), REAL(0.0)};
        for (int k = first; k < first + count; k++) {
            mean[0] += memory.pending[k][0];
            mean[1] += memory.pending[k][1];
        }
        mean[0] /= (real)count;
        mean[1] /= (real)count;
        predict(later, rotors, mean, (real)count * PERIOD, change);
        move(later, REAL(1.0), change, later);
    }
#endif
    regulate(arrival, later, rotors, u);
}

/* Remembers what was commanded, and simulates the model a period on. */
static void run_on(const real applied[2]) {
    real change[6];
    memory.pending[DELAY][0] = applied[0];
    memory.pending[DELAY][1] = applied[1];
    predict(memory.x, memory.rotors, memory.pending[0], PERIOD, change);
    for (int i = 0; i < 6; i++) {
        add(i, change[i]);
    }
#if DELAY
    for (int k = 0; k < DELAY; k++) {
        memory.pending[k][0] = memory.pending[k + 1][0];
        memory.pending[k][1] = memory.pending[k + 1][1];
    }
#endif
}

static void base_remember(real t, const real u[2], const real applied[2]) {
    const int now = index_of(t);
    if (u[0] == applied[0] && u[1] == applied[1]) { /* anti-windup */
        memory.integral[0] += PERIOD * (memory.x[0] - STATE[now][0]);
        memory.integral[1] += PERIOD * (memory.x[2] - STATE[now][2]);
    }
    run_on(applied);
}

/* A period without a measurement: the model goes on alone. */
static void base_miss(const real applied[2]) {
    if (memory.started) {
        run_on(applied);
    }
}
