
void heli_reset(void) {
    base_reset();
}

void heli_step(real t, const real y[6], real u[2]) {
    real wanted[2];
    if (!is_measured(y)) {
        u[0] = u[1] = SAFE_VOLTAGE;
        base_miss(u);
        return;
    }
    base_control(t, y, wanted);
    u[0] = saturate(wanted[0]);
    u[1] = saturate(wanted[1]);
    base_remember(t, wanted, u);
}
