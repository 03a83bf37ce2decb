(** A state as a node of a graph on which formulas are evaluated: what is known of it without its geometry; and how
    owners send nodes. *)

open Scc_exact
open Scc_ctl
open Scc_codec

(** A transition of the state. *)
type step = { duration : Rat.t; chance : Rat.t option  (** if chance decides *) }

type follows =
  | Unknown  (** it was not expanded *)
  | Rests  (** nothing, and time passes for ever *)
  | Steps of step array  (** its transitions, in order; there may be none *)

type t = {
  number : int;
  follows : follows;
  truths : Truth.t array;  (** by predicate, in the state *)
  along : (int * Truth.t Timeline.t) list;  (** predicates that change while time passes after it *)
  counts : (int * int) array list;
  (** for each pattern of events, how many happen by each transition without duration: at least and at most *)
}

val extent : follows -> Timeline.extent
(** How long time passes after the state before anything else happens. *)

module Step : Hashtbl.HashedType with type t = step
(** Equality of transitions. *)

(** {1 As bytes} *)

type direction
(** What has been sent over a connection, or has come: each kind of step is sent once, and then a number. *)

val direction : unit -> direction
(** Nothing yet. *)

val put : direction -> Buffer.t -> t -> unit
(** Appends the bytes of a node. *)

val read : direction -> size:int -> predicates:int -> patterns:int -> Packed.source -> t
(** Reads what {!put} has appended, in the same order. There are [size] nodes and so many predicates and patterns
    of events. Raises [Packed.Malformed]. *)

val put_extent : Buffer.t -> Timeline.extent -> unit
(** Appends the bytes of an extent. *)

val read_extent : Packed.source -> Timeline.extent
(** Reads them. Raises [Packed.Malformed]. *)

val put_text : Buffer.t -> string -> unit
(** Appends a text for [Packed.text]. *)
