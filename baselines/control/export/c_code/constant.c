/* The same voltages, whatever happens. */

static void base_reset(void) {
}

static void base_control(real t, const real y[6], real u[2]) {
    (void)t;
    (void)y;
    u[0] = u[1] = CONSTANT_VOLTAGE;
}

static void base_remember(real t, const real wanted[2], const real applied[2]) {
    (void)t;
    (void)wanted;
    (void)applied;
}

static void base_miss(const real applied[2]) {
    (void)applied;
}
