(** What is read of VRML97 and X3D 3.0 to 4.0. Each node of these formats is read, or is known to leave the places
    of points as they are, or is refused. So is each field of a node that is read. *)

(** What a node that is read is made of. *)
type role =
  | Group  (** shows all that is inside *)
  | Transform  (** moves what is inside *)
  | Switch  (** shows one of its choices *)
  | Levels  (** shows the first of its levels, which has the most details *)
  | Inline  (** shows what is in another file *)
  | Shape  (** shows a geometry *)
  | Geometry
  | Points  (** coordinates of a geometry *)

type t =
  | Read of { role : role; read : string list; still : string list }
  (** its fields that are read, and those that leave the places of points as they are *)
  | Still  (** changes no place of a point *)
  | Left_out  (** a geometry of lines or letters: without thickness, so that it bounds no solid *)
  | Unread of string  (** what can be done about it *)

val find : string -> t
(** [find kind] is how nodes of that type are treated; unknown types are [Unread]. *)

val refers : string -> string -> bool
(** [refers kind field] is true if a field of nodes of the type [kind] may have nodes of any type, of which
    nothing is shown there. *)

val cure : string -> string
(** [cure kind] is what can be done about a node of a type that is not read. *)

val kinds : string list
(** All types that are not [Unread]. *)

val usual : string -> string
(** [usual kind] is the field in which an XML element of that type stands inside another one, unless it says
    otherwise. *)
