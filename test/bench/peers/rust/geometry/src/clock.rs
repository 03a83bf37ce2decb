//! The time of one query.

use std::hint::black_box;

#[repr(C)]
struct Timespec {
    seconds: i64,
    nanoseconds: i64,
}

extern "C" {
    fn clock_gettime(clock: i32, time: *mut Timespec) -> i32;
}

/// Processor time of this process, in nanoseconds.
fn clock() -> f64 {
    const PROCESS_CPUTIME: i32 = 2;
    let mut t = Timespec { seconds: 0, nanoseconds: 0 };
    unsafe { clock_gettime(PROCESS_CPUTIME, &mut t) };
    t.seconds as f64 * 1e9 + t.nanoseconds as f64
}

/// The mean over as many passes through all pairs as take 0.1 s, after one pass to warm up.
pub fn nanoseconds<T>(n: usize, query: impl Fn(usize) -> T) -> f64 {
    let pass = || {
        for i in 0..n {
            black_box(query(black_box(i)));
        }
    };
    pass();
    let (start, mut passes) = (clock(), 0);
    loop {
        pass();
        passes += 1;
        let elapsed = clock() - start;
        if elapsed >= 1e8 {
            return elapsed / (passes * n) as f64;
        }
    }
}
