(** What an owner tells the others of a round, where states are taken in the order of time. *)

open Scc_exact
open Scc_ctl
open Scc_codec

(** When a goal is met: the moment; and what was found when, by the turn of the state that was expanded, and the
    place among what was found then. *)
type event = { moment : Timeline.moment; turn : int; place : int; owner : int; id : int }

type t = {
  found : int;  (** new states *)
  ranked : int;  (** states that have come or become earlier *)
  transitions : int;  (** of the states that it has expanded *)
  too_long : int;  (** new states that are not to be expanded *)
  opened : int option;  (** the turn of the first state whose transitions were computed *)
  met : event option array;  (** by goal: the earliest moment *)
  next : (Rat.t * int) option;
  (** the earliest time of states to be expanded, and the least turn that they may have *)
  faults : (string * int) list;  (** each once, with the first turn *)
  ends : string list;  (** each once *)
}

val earlier : event option -> event option -> event option
(** The one of the earlier moment; of equal moments, the one that was found first. *)

val put : Buffer.t -> t -> unit
(** Appends the bytes of what is told. *)

val read : Packed.source -> t
(** Reads the bytes of {!put}. Raises [Packed.Malformed]. *)

val merge : t array -> t
(** What all owners tell together. The array is not empty. *)
