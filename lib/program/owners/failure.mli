(** How the work of an owner fails because of others. *)

open Scc_base

type t =
  | Refused of Diag.t  (** another process is no owner of this exploration, or says what none would say *)
  | Lost of string  (** another process or a limit ended it, for this reason *)

exception Failed of t

val refused : ('a, unit, string, 'b) format4 -> 'a
(** [refused fmt ...] raises {!Failed} for a process that belongs to another exploration, for a message that does
    not fit its format, and for a file that does not: SC0924. *)

val lost : ('a, unit, string, 'b) format4 -> 'a
(** [lost fmt ...] raises {!Failed} for a process that has ended or does not answer. *)
