(** How states are divided between the process that has the graph and the workers ({!Crew}). The division depends
    on the time to find transitions, the time to send states and to receive answers, and on which side waits for
    the other. All of this is measured during the exploration. No result depends on it. *)

type t

val create : now:(unit -> float) -> t
(** A balance without measurements. [now] is a clock, in seconds. *)

(** {1 What is measured} *)

val finding : t -> (unit -> 'a) -> 'a
(** [finding b work] is [work ()], which finds the transitions of one state in this process. Its time is
    measured, of some calls for all. *)

val pays : t -> bool
(** [pays b] is true if finding a state's transitions in this process takes more than 2.5 microseconds on
    average, so that workers may help. *)

val telling : t -> (unit -> 'a) -> 'a
(** [telling b work] is [work ()], which builds a request of some states. Its time is measured. The time of the
    system to carry the request is left out: it is long for a request of few states, and requests are short where
    few states are sent. *)

val hearing : t -> int -> (unit -> 'a) -> 'a
(** [hearing b i work] is [work ()], which reads the answer about the state with number [i]. Its time is
    measured, of some calls for all. *)

val waited : t -> unit
(** Notes that this process had nothing to do while a worker worked. One state more of each 64 is left to this
    process from then on. *)

val answered : t -> states:int -> waited:float -> worked:float -> unit
(** Notes that a worker has found the transitions of [states] states in [worked] seconds, and had nothing to do for
    [waited] seconds before. *)

(** {1 What follows} *)

val is_here : t -> int -> bool
(** [is_here b i] is true if the state with number [i] is left to this process, unless a worker has nothing to
    do. *)

val batch : t -> int
(** The greatest number of states in a request. *)

val least : t -> int
(** The least number of states in a request to a worker that has nothing to do. *)

val least_ahead : t -> int
(** The least number of states in a request to a worker that has another request under way. *)

val between_looks : t -> int
(** The number of states after which this process checks for replies. *)
