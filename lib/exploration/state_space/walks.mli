(** Steps of walkers that wait where they are blocked (rule Blocked), between the draws of two instants (rule
    JoinedDraws). What two processes are to each other in a step is found once for each two, in a cache. *)

open Scc_exact

type t

val make : units:Course_units.t list -> most:int -> Local.t -> t option
(** [make ~units ~most local] has empty caches, which grow to [most] processes, a power of two, and to 16 times as
    many pairs. [units] are what formulas see of the way. The result is [None] for models to which nothing here
    applies: walkers bounce or stop, bodies turn, bind at rest or split by lot, or steps are not those of all. *)

val standing : t -> int array -> int array
(** [standing w tuple] is the state that stands for [tuple]. In a state in which a step begins, nothing may happen
    before all walkers draw again, and no unit may see where they are on the way. Then it is the state in which they
    are at rest where they will be in the end. Else it is [tuple] itself. *)

val pass : t -> int array -> (int * int array) option
(** [pass w tuple] is the passing of time through a step that begins in [tuple], as the number of its label and its
    target, whose walkers have lost their velocities. It is the only transition. The result is [None] if something
    may happen before all walkers draw again, or if less than two of them do. *)

val outcomes : t -> int array -> representative:(int array -> int array) -> Joint_draws.outcome list option
(** [outcomes w tuple ~representative] is the joint distribution of all draws in a state in which all walkers wait to
    draw, as states in which the step begins, each once. The result is [None] where other processes move, a law cannot
    be evaluated, or outcomes are more than 2{^18}. *)

val towards : t -> int array -> (int array -> bool) -> (int * Vec.t) list option
(** [towards w tuple test] is the slots of the walkers and the velocities that they draw from [tuple], so that the
    state after it passes the test. *)
