(** A drawn solid, from its set of faces to its convex parts. *)

open Scc_geometry

type fault =
  | Unsound of Sound.fault
  | Pieces of Shells.fault  (** not one solid *)
  | Inside_out of { face : int; whole : bool }
  (** of a union: a piece of surface is inside out, and is no hollow ({!United.fault}) *)
  | Nothing  (** closed faces of a union that surround no point *)
  | Too_many of int
  (** more parts than this number, or more than twenty times as many cells that they are cut from and joined *)

val most_parts : int
(** 10 000, the greatest number of parts if no other one is given. *)

val message : Polyhedron.ifs -> fault -> Scc_base.Code.t * string
(** The code and the message of a fault that concerns more than single faces. A fault [Structure] is a bug
    here: {!Scc_geometry.Polyhedron_fault} has its messages. *)

val surface : Polyhedron.ifs -> (Drawn.t, fault) result
(** The surface of one solid, whose faces are sound ({!Sound}) and in one piece ({!Shells}). The fault is never
    [Too_many]. *)

(** The progress of a decomposition: its last step. *)
type progress =
  | Looking of int  (** the number of faces that are checked *)
  | Uniting of int  (** the number of pairs and pieces of faces considered so far *)
  | Cutting of int  (** the number of cells and pairs of cells considered so far *)
  | Making of int * int  (** the number of the part being made, and the number of all parts *)
  | Naming of int  (** the number of parts left whose faces need names *)

val make : ?progress:(progress -> unit) -> ?names:bool -> ?most:int -> Polyhedron.ifs -> (Parts.t, fault) result
(** The solid in convex parts: those of {!Scc_polygon.Prism} for a prism over a polygon, and of
    {!Scc_decompose.Decompose} for any other solid. With [names], the default, they are cut further so that
    names of the solid's faces are exact ({!Parts.make}). A convex solid is one part. There are at most
    [most] parts ({!most_parts}). The function [progress] is called again and again, and may raise. *)

val united :
  ?progress:(progress -> unit) -> ?names:bool -> ?most:int -> Polyhedron.ifs -> (Parts.t, fault) result
(** The union of solids that overlap or touch ({!United}) in convex parts, which need not be connected. Each of its
    solids is cut by itself, as {!make} does. Faces are those of the union, named as {!United.surface} says. With
    [names], parts are cut further so that these are exact; it is false by default. A set that bounds no union has
    the faults of {!Sound.faults}. *)

val convex_whole : Parts.t -> Polyhedron.ifs option
(** The surface of the union of all parts, if that is convex, with the names of its faces and corners. *)

val groups : Parts.t -> int
(** The number of groups of parts that are connected by areas; 1 for the parts of {!make}. *)
