5 passed, 1 failed
