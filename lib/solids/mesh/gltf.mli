(** glTF 2.0 of Khronos, as JSON or GLB: the triangles of the meshes of a scene, moved by their nodes. *)

open Scc_base
open Scc_geometry

val read : files:Beside.reader -> path:string -> string -> (Polyhedron.ifs * Diag.t list, Diag.t) result
(** The triangles or points of a file. Positions are the numbers of the file, exactly: 32-bit ones, or
    integers (KHR_mesh_quantization). Matrices,
    translations, scales and quaternions are the decimals that are written. A quaternion, whose length rounding
    makes differ from 1, is divided by its length: the rotation has rational entries. Equal points are one
    vertex, and {!Merge_coplanar} makes faces, as for STL. Meshes are those of the scene of the file, else of
    its first scene, else of all its nodes; without nodes, all meshes. Points without triangles are a cloud.
    Data may be in other files beside it ({!Beside}). A warning says that there are animations (SC0324).
    Refused (SC0320): lines, skins, morphed meshes, and all properties and extensions that {!Gltf_table} does not
    list. *)
