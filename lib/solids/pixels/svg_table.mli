(** What is read of SVG 1.1 and SVG 2: each element, attribute and property is read, or is known to leave what is
    painted as it is, or is refused. *)

type t =
  | Read
  | Still  (** paints nothing, and changes nothing of what is painted *)
  | Unread of string  (** what can be done about it *)

(** What an element is. *)
type element =
  | Group  (** paints what is in it *)
  | Shape  (** has an outline *)
  | Use  (** paints what it refers to *)
  | Viewport  (** a drawing within the drawing *)
  | Silent  (** paints nothing by itself, with all that is in it *)
  | Refused of string  (** what can be done about it *)

val element : string -> element
(** [element name] is how an element of the namespace of SVG is treated; unknown ones are refused. *)

val within_shape : string -> bool
(** [within_shape name] is true if such an element may stand in a shape, and changes nothing of it. *)

val is_condition : string -> bool
(** [is_condition name] is true of an attribute by which a [switch] chooses ({!Svg_switch}). *)

val attribute : string -> string -> t
(** [attribute element name] is how an attribute without a namespace is treated. *)

val property : string -> t
(** [property name] is how a declaration of a style is treated; [name] is in small letters. *)

val harmless : (string * string) list
(** Properties that are read only to see that they have the one value that changes nothing, and that value. *)
