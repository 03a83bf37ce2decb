(** 3MF, the 3D Manufacturing Format: the core specification, 1.4, of the 3MF Consortium. A package (a ZIP file) in
    which a part of XML tells objects, as triangles or as components made of other objects, and which of them are
    built. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** The triangles of the items to be built, moved by their transforms and those of components; all numbers are the
    decimals that are written. As for STL and glTF, equal points are one vertex, and {!Merge_coplanar} makes faces;
    a mirror turns faces over, so that they stay outside. The unit of length is not looked at. Supports are left
    out.

    Refused (SC0320): extensions that the file says are required, but those that leave triangles as they are
    (colours, names of parts, sets of triangles); parts of a model in other parts of the package; objects that are
    used before they are told, so that none is inside of itself; components upon components that have many times
    the triangles that the size of the file has room for, or get too long numbers; and what {!Archive} and
    {!Xml_part} refuse. *)
