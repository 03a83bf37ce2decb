(** How the work of an owner fails because of others. *)

open Scc_base

type t =
  | Refused of Diag.t  (** another process is no owner of this exploration, or says what none would say *)
  | Lost of string  (** another process or a limit ended it, for this reason *)

exception Failed of t

val other : ('a, unit, string, 'b) format4 -> 'a
(** [other fmt ...] raises {!Failed} for a process that belongs to another exploration: SC0924. *)

val garbled : ('a, unit, string, 'b) format4 -> 'a
(** [garbled fmt ...] raises {!Failed} for a message that does not fit its format: SC0925. *)

val lost : ('a, unit, string, 'b) format4 -> 'a
(** [lost fmt ...] raises {!Failed} for a process that has ended or does not answer. *)
