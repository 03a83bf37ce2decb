(** Style sheets of CSS with selectors by names, classes and ids. Reading raises {!Svg_number.Bad} for a text
    that violates the format, and {!Svg_number.Unread} for selectors and rules that are not supported. *)

(** What selectors see of an element. *)
type subject = { name : string; id : string option; classes : string list }

type declaration = { property : string;  (** in lower case *) value : string; important : bool }

val declarations : valid:(string -> string -> bool) -> string -> declaration list
(** The declarations of a text such as that of the attribute [style], in their order. [valid property value] is
    false for what CSS ignores; it is left out where a valid value of the same property is before it. *)

val ends_with_point : string -> bool
(** [ends_with_point value] is true if a number in a value ends with a point: in CSS, but not in attributes, this
    is a fault. *)

type rule
(** A selector with its declarations. *)

val rules : valid:(string -> string -> bool) -> string -> rule list
(** The rules of the text of a [style] element, one for each selector, with the {!declarations} of their
    blocks. Selectors are [*], names, [.class], [#id] and [:root], together, and one within another ([a b], [a
    > b]). A selector with [:hover], [:active], [:focus] or [:visited] selects nothing. [@charset] and
    [@font-face] change nothing. *)

type t
(** A style sheet. *)

val sheet : rule list list -> t
(** [sheet rules] is the sheet of the rules of the [style] elements of a document, in their order; at most 1 000
    rules. *)

val is_empty : t -> bool
(** [is_empty sheet] is true if there are no rules. *)

val declared : t -> subject list -> declaration list
(** [declared sheet chain] are the declarations for an element, those that count most last: by the specificity
    of their selectors, and then by their order. [important] ones are among the others. [chain] is the element
    and all that is around it, the element first. Raises {!Svg_number.Bad} when the elements and selectors of a
    document are too many to be compared. *)
