(** The columns of frames about many states: see [specs/successors.md]. *)

open Scc_graph_search
open Scc_ctl

(** {1 States that are expanded} *)

(** The columns of expanded states. *)
type states = {
  follows : Buffer.t;
  counts : Buffer.t;
  ahead : Buffer.t;
  mutable notes : Told.note list;  (** texts beside the numbers, the last first *)
}

val states : unit -> states
(** Empty columns. *)

val clear : states -> unit
(** Empties the columns. *)

val read :
  Filter.t -> states -> string -> from:int -> int array -> (int -> int array -> Lts.step list -> unit) -> unit
(** [read filter columns frame ~from lengths work] reads the states of a frame, which begin at [from] and have
    these lengths. It adds the columns of what follows each state. [work] receives the index of each state, the
    state and its transitions. *)

(** {1 Targets} *)

(** The columns of targets of transitions. *)
type targets = {
  flags : Buffer.t;
  goals : Buffer.t;
  lengths : Buffer.t;
  bytes : Buffer.t;
  mutable doubts : (int * Truth.t array) list;  (** goals that are undecided, the last first *)
}

val targets : unit -> targets
(** Empty columns. *)

val clear_targets : targets -> unit
(** Empties the columns. *)

val put_target : Filter.t -> targets -> int -> int array -> Keys.fingerprint -> unit
(** [put_target filter columns index tuple print] adds a target with its fingerprint. The tuple may be changed
    afterwards. *)

