(** How many states processes take at a time ({!Crew}), by how long it takes to find the transitions of one,
    which is measured during the exploration. No result depends on it. *)

type t

val create : now:(unit -> float) -> t
(** A balance without measurements. [now] is a clock, in seconds. *)

val request_seconds : float
(** Seconds of work that a request is to be worth. *)

(** {1 What is measured} *)

val finding : t -> (unit -> 'a) -> 'a
(** [finding b work] is [work ()], which finds the transitions of one state in this process. Its time is
    measured, of some calls for all. *)

val pays : t -> bool
(** [pays b] is true if finding a state's transitions in this process takes so long that workers help. *)

val answered : t -> states:int -> worked:float -> unit
(** Notes that a worker has found the transitions of [states] states in [worked] seconds. *)

(** {1 What follows} *)

val request : t -> waiting:int -> jobs:int -> int
(** The number of states that a process takes at a time, if so many wait and so many processes work. *)
