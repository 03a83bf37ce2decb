(** Scenes of VRML and X3D: nodes with fields, however they are written. *)

open Scc_base

type node = {
  kind : Text.word;  (** the type of the node, at its place *)
  name : string option;  (** given by [DEF] *)
  fields : (Text.word * value) list;  (** in the order of the file, each with its name and its place *)
}

(** The value of a field: words, as numbers and strings are written, or nodes. An empty list is [Words []]. A node
    that is used several times is shared. *)
and value = Words of Text.word list | Nodes of node list

type route = { at : Text.word; node : string;  (** whose field is set while time passes *) field : string }

type file = { nodes : node list; routes : route list; names : (string, node) Hashtbl.t  (** by [DEF] *) }

exception Refused of Diag.t
(** A fault, located in the file. *)

val ok : ('a, Diag.t) result -> 'a
(** The value; raises {!Refused} with the fault. *)

val bad : path:string -> Text.word -> ('a, unit, string, 'b) format4 -> 'a
(** Raises {!Refused} with SC0320, at the word. *)

val unread : path:string -> Text.word -> hint:string -> ('a, unit, string, 'b) format4 -> 'a
(** Raises {!Refused} with SC0321, at the word: something that the format has, and that is not read. *)

val max_depth : int
(** The greatest depth of nodes inside of each other: 1000. *)

type names
(** The names of [DEF] that were met so far, while a file is read. *)

val names : unit -> names
(** No names. *)

val opening : names -> string option -> unit
(** [opening names name] is called when a node begins, and [name] is its name. *)

val closing : names -> node -> unit
(** [closing names node] is called when the node is complete: its name is known from here on. *)

val used : path:string -> names -> Text.word -> node
(** [used ~path names word] is the last node of that name. An unknown name, and a node inside of itself, raise
    {!Refused}. So no node of a file is inside of itself. *)

val known : names -> (string, node) Hashtbl.t
(** The last node of each name. *)
