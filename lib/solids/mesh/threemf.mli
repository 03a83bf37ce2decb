(** 3MF, the 3D Manufacturing Format: the core specification, 1.4, of the 3MF Consortium. A file is a package
    (a ZIP file) with a part of XML. That part defines objects, as triangles or as components made of other
    objects, and lists those that are built. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs * Diag.t list, Diag.t) result
(** The triangles of the items to be built, moved by their transforms and those of components. All numbers are
    the decimals that are written. As for STL and glTF, equal points are one vertex, and {!Merge_coplanar}
    makes faces. A mirror turns faces over, so that they still face outside. The unit of length is ignored.
    Supports are dropped. Objects may be in other parts of the package (production extension). A warning names
    the first thing of an extension that is not known here, and that the file does not require (SC0324).

    Refused (SC0320): required extensions, but for those that leave triangles as they are (colours, names of
    parts, sets of triangles, parts elsewhere). Extensions that make shapes are refused even if they are not
    required ({!Threemf_table}), and so are objects that are used before they are defined, and parts that name
    each other. So no object contains itself. Nested components with many times the
    triangles that the size of the file can hold, or with too long numbers, are refused. So are all inputs that
    {!Archive} and {!Xml_part} refuse. *)
