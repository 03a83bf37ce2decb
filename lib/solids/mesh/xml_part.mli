(** An XML part of a package, read from its start to its end by Xmlm. Document types, and with them entities of
    their own, are refused, and so are elements that are nested more than 100 deep. *)

open Scc_base

exception Refused of Diag.t
(** SC0320; the message names the part and the line. *)

type t

val fail : t -> ('a, unit, string, 'b) format4 -> 'a
(** Raises {!Refused}: something is wrong here. *)

val read : path:string -> part:string -> string -> (t -> Xmlm.tag -> 'a) -> 'a
(** Gives the root to a function that reads all of it ({!children}); nothing but blanks and comments may follow. *)

val children : t -> (Xmlm.tag -> unit) -> unit
(** The elements in the one whose tag was given last, one by one; each has to be read too, by {!children} or
    {!skip}. Text is skipped. *)

val skip : t -> unit
(** The rest of the element whose tag was given last. *)

val attribute : Xmlm.tag -> string -> string option
(** Of no namespace, without blanks around it. *)

val needed : t -> Xmlm.tag -> string -> string
