(** The elements of an SVG document as a tree. *)

type node = {
  name : string;
  attributes : (string * string) list;  (** those without a namespace, and [href] of XLink as ["xlink:href"] *)
  at : int * int;  (** line and column after its name in its start tag, from 1 *)
  parent : node option;
  mutable children : node list;  (** elements of SVG, in their order *)
  mutable text : string list;  (** of [style], [text] and [tspan], in pieces, the last one first *)
}

type t = {
  root : node;
  ids : (string, node) Hashtbl.t;  (** the first element with each id *)
  sheet : Css.t;
  valid : string -> string -> bool;  (** of properties and their values, as for {!Css.declarations} *)
  program : (int * int) option;  (** the place of the first [script] or attribute [on...] *)
}

exception Fault of (int * int) * exn
(** A fault {!Svg_number.Bad}, {!Svg_number.Unread} or {!Svg_number.Beyond} at a place. *)

val at : node -> (unit -> 'a) -> 'a
(** [at node f] is [f ()]. A fault that [f] raises becomes a {!Fault} at the place of the element. *)

val max_depth : int
(** How deep elements may be nested: 200. *)

val read : valid:(string -> string -> bool) -> string -> t
(** The tree of a document; [valid] is as for {!Css.declarations}. Elements of other namespaces, and elements
    with what they hold that are never drawn ([title], [desc], [metadata], [script]), are left out. Raises
    {!Fault}, and [Xmlm.Error] for XML that is not well formed. *)

val iter : (node -> unit) -> node -> unit
(** [iter f node] applies [f] to the element and to all in it, in the order of the document. *)

val attribute : node -> string -> string option
(** [attribute node name] is the value of an attribute. *)

val href : node -> string option
(** The reference of an element: [href], or else [xlink:href]. *)

val declared : t -> node -> (string * string) list
(** The properties of an element that are read ({!Svg_declarations.of_element}), from its attributes, the style
    sheets and its style; later ones count more. Raises {!Svg_number.Bad} and {!Svg_number.Unread}. *)
