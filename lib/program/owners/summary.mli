(** What an owner tells the others of its part of a level. *)

open Scc_codec

type t = {
  fresh : int;  (** new states *)
  transitions : int;  (** of the states that it has expanded *)
  too_long : int;  (** new states that are not to be expanded *)
  too_deep : int;  (** likewise, after too many transitions without duration *)
  keep : bool;  (** the level is to be kept *)
  met : Progress.event option array;  (** by goal: when it first holds *)
  doubts : Progress.event option array;  (** by goal: when it is first undecided *)
  faults : (string * int) list;  (** each once, with the first rank *)
  ends : string list;  (** each once *)
}

val put : Buffer.t -> t -> unit
(** Appends the bytes of a summary. *)

val read : Packed.source -> t
(** Reads the bytes of {!put}. Raises [Packed.Malformed]. *)

val merge : t array -> t
(** The summary of all owners together. The array is not empty. *)
