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

(** What a route changes while time passes: a field of a node, something of an instance of a prototype, or nothing,
    as no node has this name. *)
type change = { at : Text.word; target : target }

and target = Field of node * string | Instance | Nobody of string

(** A route, with its place, from a node to a field of a node. *)
type route = { place : Text.word; from : string; node : string; field : string }

type file = {
  nodes : node list;
  changes : change list;
  length : Scc_exact.Rat.t;  (** the unit of length, in metres, as {!Scene_unit.length} has it *)
}

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

val instance : names -> node -> unit
(** [instance names node] is called instead of {!closing} for an instance of a prototype. *)

val changes : names -> route list -> change list
(** The changes by routes. *)

(** {1 Prototypes} *)

type fields = (string * value option) list
(** The values of fields, by name; [None] for events. *)

(** How an interface declares a field: an event that comes in or goes out, a value, a value with events, or without
    a word of it. *)
type access = In | Out | Field | Exposed | Unsaid

type declared = {
  field : Text.word;  (** its name *)
  type_ : string;  (** its type, [""] if that is not stated *)
  access : access;
}
(** A field of an interface. *)

type interface = declared list
(** What a prototype declares. *)

val access_name : access -> string
(** How a message names that. *)

val type_of : interface -> string -> string
(** The type of a field, [""] if it is not stated or there is no such field. *)

type elsewhere = {
  path : string;  (** the file that declares it so *)
  name : string;  (** in that file *)
  interface : interface;  (** what it declares of that prototype *)
  at : Text.word;  (** where its addresses are *)
  urls : string list;
}
(** A prototype in another file. *)

(** What is declared: in another file, around this place, or in this file before it, with its body. *)
type 'body prototype =
  | Elsewhere of elsewhere
  | Inside
  | Own of { interface : interface; fields : fields; body : 'body }

val within : string -> (string * 'body prototype) list -> (string * 'body prototype) list
(** [within name known] are the prototypes that the body of [name] can use, if those in [known] are declared before
    it. *)

val inside : path:string -> Text.word -> string -> 'a
(** A prototype of that name is used inside of itself: raises {!Refused}. *)

val check_twice : path:string -> Text.word list -> unit
(** A name that is there twice raises {!Refused} at its second place. *)

val check_interface : path:string -> interface -> unit
(** A field that is declared twice raises {!Refused}. *)

type scope
(** The names of prototypes that a file, or the body of a prototype, has declared so far. *)

val scope : unit -> scope
(** No names. *)

val declare : path:string -> scope -> Text.word -> unit
(** A prototype of that name is declared in the scope. It raises {!Refused} if that has one of this name, and if
    VRML 97 has a node of this name. *)

val given : path:string -> Text.word -> interface -> fields -> (Text.word * value) list -> fields
(** [given ~path kind interface fields values] are the fields of a prototype with the values of an instance. A
    value for what is no field with a value in [interface] raises {!Refused} (SC0321). So does one that is given
    twice (SC0320). *)

val connected : path:string -> fields -> Text.word -> value option
(** The value of a field of the prototype to which a field of a node in its body is connected ([IS]); [None] for an
    event. An unknown name raises {!Refused}. *)

val spend : path:string -> int ref -> Text.word -> int -> unit
(** [spend ~path room word n] takes [n] from what is left in [room]. If that is not enough, it raises {!Refused}:
    nodes that are used again and again could make any size of a short file. *)

val room : size:int -> int ref
(** The room for a file of that length. *)
