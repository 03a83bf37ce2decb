(** Where checks hold, as a script of SMT-LIB 2.6 (C. Barrett, P. Fontaine and C. Tinelli, {e The SMT-LIB
    standard}), in the logic QF_LRA: linear arithmetic over the reals. *)

open Scc_calculus

val script : Ranges.t -> numbers:(string * Chances.t) list -> (string * Where.t) list -> string
(** A script that declares the parameters and asserts that they are in their ranges. For a check [meets] it
    defines the truth values [meets-holds], [meets-fails] and [meets-unknown]. Exactly one of them is true in
    the ranges. The checks have different names, and these ranges. A parameter with the name of a function of
    SMT-LIB, as [abs], is called [param-abs]. For a number [mean] it defines the real functions [mean-low] and
    [mean-high], which are its bounds in the ranges, and the truth values [mean-low-infinite] and
    [mean-high-infinite]: where these are true, there is no such bound, and the function is 0. The script
    has no query: users append their own. *)
