(** What has become of each state of a graph: a byte for each, and next to nothing where neighbours are alike. *)

(** Why a state has not been expanded. *)
type 'fault reason =
  | Depth
  | Time
  | Instant
  | States
  | Bits  (** it has a number that is too long *)
  | Seconds
  | Memory
  | Interrupted
  | Stopped  (** the visitor had seen enough *)
  | Fault of 'fault  (** its transitions cannot be computed *)

val of_stop : Limits.stop -> 'fault reason

type 'fault status =
  | Expanded
  | Queued
  | Unexpanded of 'fault reason

type 'fault t

val create : unit -> 'fault t

val get : 'fault t -> int -> 'fault status
(** Of a state whose status has been set. *)

val set : 'fault t -> int -> 'fault status -> unit

val unexpanded : 'fault t -> int
(** How many states are. *)

val count : 'fault t -> 'fault reason -> int
(** How many are for this reason; all faults count together. *)

val is_expanded : 'fault t -> int -> bool

val note_timed : 'fault t -> int -> unit
(** A state that has been expanded has no edges but such as take time. *)

val is_timed : 'fault t -> int -> bool
(** Whether that has been noted. *)

val bytes : 'fault t -> int
(** About how much memory it takes. *)
