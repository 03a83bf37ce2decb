(** OBJ files (Wavefront): the statements [v] and [f] (with [/vt] and [/vn], and with negative, relative
    indices). Faces are named by groups ([g]), or by objects ([o]) where there are no groups ({!Face_names}).
    Materials, normals, texture coordinates and what says how faces look are skipped. Several objects of one file
    make one set of faces. *)

open Scc_base
open Scc_geometry

type treatment =
  | Read
  | Still  (** moves no point *)
  | Left_out  (** with a warning: lines and points *)
  | Refused of string  (** why *)

val keywords : (string * treatment) list
(** All statements of the specification, by their first words. *)

val read : path:string -> string -> (Polyhedron.ifs * Diag.t list, Diag.t) result
(** [read ~path text] is the set of faces of a file, with a warning (SC0324) if lines or points are left out.
    Errors (SC0320) are located in the file. *)
