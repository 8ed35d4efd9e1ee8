/* A regulator on a model that runs along: of rotors and delay and, with an observer, of disturbances. */

static struct model {
    int started, start;
    real x[6];                  /* state, predicted */
    real carry[6];              /* what rounding has taken off it (Kahan's summation) */
    real disturbance[3];        /* rad/s^2 */
    real rotors[2];             /* V */
    real pending[DELAY + 1][2]; /* V, commanded and not yet in effect, the oldest first */
    real integral[2];           /* rad s */
} memory;

static void derivative(const real x[6], const real v[2], real dx[6]) {
    dx[0] = x[1];
    dx[1] = B1 * COS(x[2]) * SIN(x[4]) * v[0] - C1 * x[1] + memory.disturbance[0];
    dx[2] = x[3];
    dx[3] = A1 * SIN(x[2]) + A2 * COS(x[2]) + B2 * COS(x[4]) * v[0] - C2 * x[3] + memory.disturbance[1];
    dx[4] = x[5];
    dx[5] = A3 * COS(x[2]) * SIN(x[4]) + B3 * v[1] - C3 * x[5] + memory.disturbance[2];
}

static void virtual_input(const real u[2], real v[2]) {
    const real front = front_thrust(u[0]), back = back_thrust(u[1]);
    v[0] = front + back;
    v[1] = front - back;
}

static void move(const real x[6], real h, const real dx[6], real moved[6]) {
    for (int i = 0; i < 6; i++) {
        moved[i] = x[i] + h * dx[i];
    }
}

/* The state's change in h seconds, by one Runge-Kutta step of order four, and the rotors after it, exactly. */
static void predict(const real x[6], real rotors[2], const real u[2], real h, real change[6]) {
#if LAGGING
    const real half_decay = EXP(-REAL(0.5) * h / LAG), decay = EXP(-h / LAG);
#else
    const real half_decay = REAL(0.0), decay = REAL(0.0);
#endif
    real middle[2], end[2], v0[2], v1[2], v2[2], d1[6], d2[6], d3[6], d4[6], moved[6];
    for (int i = 0; i < 2; i++) {
        middle[i] = u[i] + half_decay * (rotors[i] - u[i]);
        end[i] = u[i] + decay * (rotors[i] - u[i]);
    }
    virtual_input(LAGGING ? rotors : u, v0);
    virtual_input(middle, v1);
    virtual_input(end, v2);
    derivative(x, v0, d1);
    move(x, REAL(0.5) * h, d1, moved);
    derivative(moved, v1, d2);
    move(x, REAL(0.5) * h, d2, moved);
    derivative(moved, v1, d3);
    move(x, h, d3, moved);
    derivative(moved, v2, d4);
    for (int i = 0; i < 6; i++) {
        change[i] = h / REAL(6.0) * (d1[i] + REAL(2.0) * (d2[i] + d3[i]) + d4[i]);
    }
    rotors[0] = end[0];
    rotors[1] = end[1];
}

/* memory.x[i] += change */
static void add(int i, real change) {
    const real corrected = change + memory.carry[i], sum = memory.x[i] + corrected;
    memory.carry[i] = corrected - (sum - memory.x[i]);
    memory.x[i] = sum;
}
