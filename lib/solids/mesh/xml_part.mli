(** An XML part of a package, read from its start to its end by Xmlm. Document types, and so their own
    entities, are refused. Elements that are nested more than 100 deep are refused too. *)

open Scc_base

exception Refused of Diag.t
(** SC0320; the message names the part and the line. *)

type t

val place : t -> string
(** The part and the line, in words. *)

val fail : t -> ('a, unit, string, 'b) format4 -> 'a
(** Raises {!Refused}, at the current line. *)

val read : path:string -> part:string -> string -> (t -> Xmlm.tag -> 'a) -> 'a
(** [read ~path ~part text f] calls [f] with the tag of the root; [f] reads the whole root ({!children}). Only
    blanks and comments may follow the root. *)

val children : t -> (Xmlm.tag -> unit) -> unit
(** [children t f] calls [f] for each element inside the one whose tag was given last. Each element has to be
    read too, by {!children} or {!skip}. Text is skipped. *)

val skip : t -> unit
(** Skips the rest of the element whose tag was given last. *)

val attribute : Xmlm.tag -> string -> string option
(** [attribute tag name] is the value of the attribute without a namespace, without blanks around it. *)

val needed : t -> Xmlm.tag -> string -> string
(** [needed t tag name] is the value of an {!attribute}; raises {!Refused} if it is missing. *)
