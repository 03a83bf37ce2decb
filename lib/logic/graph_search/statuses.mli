(** The status of each state of a graph, in one byte for each, and next to nothing where neighbours are alike. *)

(** Why a state has not been expanded. *)
type 'fault reason =
  | Depth  (** beyond the bound on transitions *)
  | Time  (** beyond the bound on model time *)
  | Instant  (** beyond the bound on transitions within one instant *)
  | States  (** the bound on the number of states was met *)
  | Bits  (** it has a number that is too long *)
  | Seconds  (** the exploration ended for its time *)
  | Memory  (** the exploration ended for its memory *)
  | Interrupted  (** the exploration was interrupted *)
  | Stopped  (** the visitor ended the exploration, or the state does not matter *)
  | Fault of 'fault  (** its transitions cannot be computed *)

val of_stop : Limits.stop -> 'fault reason
(** [of_stop stop] is the reason for the states that are left when [stop] ends an exploration. *)

type 'fault status =
  | Expanded  (** its transitions are in the graph *)
  | Queued  (** it waits to be expanded *)
  | Unexpanded of 'fault reason  (** it was not expanded, for this reason *)

type 'fault t

val create : unit -> 'fault t
(** [create ()] has no states. *)

val get : 'fault t -> int -> 'fault status
(** [get s i] is the status of state [i], which must have been set. *)

val set : 'fault t -> int -> 'fault status -> unit
(** [set s i status] sets the status of state [i]. *)

val unexpanded : 'fault t -> int
(** [unexpanded s] is the number of states that are [Unexpanded], in constant time. *)

val count : 'fault t -> 'fault reason -> int
(** [count s reason] is the number of states that are [Unexpanded] for this reason, in constant time. All faults
    count together. *)

val is_expanded : 'fault t -> int -> bool
(** [is_expanded s i] is true if state [i] is [Expanded]. *)

val note_timed : 'fault t -> int -> unit
(** [note_timed s i] notes that all edges of the expanded state [i] take time. *)

val is_timed : 'fault t -> int -> bool
(** [is_timed s i] is true if {!note_timed} was called for state [i], and its status was not set since. *)

val note_reduced : 'fault t -> int -> unit
(** [note_reduced s i] notes that the transitions of the expanded state [i] in the graph are its reduced ones
    ({!Lts.S.reduced}). *)

val is_reduced : 'fault t -> int -> bool
(** [is_reduced s i] is true if {!note_reduced} was called for state [i], and its status was not set since. *)

val bytes : 'fault t -> int
(** [bytes s] is about how much memory the table takes, in bytes. *)
