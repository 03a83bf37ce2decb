(** glTF 2.0 of Khronos, as JSON or GLB: the triangles of the meshes of a scene, moved by their nodes. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** Positions are the 32-bit numbers of the file, exactly; matrices, translations, scales and quaternions are the
    decimals that are written, and a quaternion, which rounding leaves not quite of length 1, is the rotation of
    what it is divided by its length: that has rational entries. Equal points are one vertex, and
    {!Merge_coplanar} makes faces, as for STL. Meshes are those of the scene of the file, else of its first one,
    else of all its nodes; without nodes, all meshes. Points without triangles are a cloud. Lines, skins, morphed
    meshes, data in other files and extensions that change what positions mean are refused (SC0320). *)
