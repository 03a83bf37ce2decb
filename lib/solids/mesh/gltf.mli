(** glTF 2.0 of Khronos, as JSON or GLB: the triangles of the meshes of a scene, moved by their nodes. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** The triangles or points of a file. Positions are the 32-bit numbers of the file, exactly. Matrices,
    translations, scales and quaternions are the decimals that are written. A quaternion, whose length rounding
    makes differ from 1, is divided by its length: the rotation has rational entries. Equal points are one
    vertex, and {!Merge_coplanar} makes faces, as for STL. Meshes are those of the scene of the file, else of
    its first scene, else of all its nodes; without nodes, all meshes. Points without triangles are a cloud.
    Refused (SC0320): lines, skins, morphed meshes, data in other files, and extensions that change the meaning
    of positions. *)
