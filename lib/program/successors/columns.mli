(** What is told of many states at once, in columns: see [specs/successors.md]. *)

open Scc_graph_search
open Scc_exchange

(** {1 States that are expanded} *)

type states = {
  follows : Buffer.t;
  counts : Buffer.t;
  ahead : Buffer.t;
  mutable notes : Json.t list;  (** what numbers do not tell, the last first *)
}

val states : unit -> states
val clear : states -> unit

val read :
  Filter.t -> states -> string -> from:int -> int array -> (int -> int array -> Lts.step list -> unit) -> unit
(** The states of a frame, by where they begin and their lengths, with what follows them; the transitions of each
    are handed over, with its index and itself. *)

(** {1 Targets} *)

type targets = {
  flags : Buffer.t;
  goals : Buffer.t;
  lengths : Buffer.t;
  bytes : Buffer.t;
  mutable doubts : Json.t list;  (** goals that are undecided, the last first *)
}

val targets : unit -> targets
val clear_targets : targets -> unit

val put_target : Filter.t -> targets -> int -> int array -> Keys.fingerprint -> unit
(** With its index; nothing of the state is kept. *)

