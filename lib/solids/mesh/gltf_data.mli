(** Numbers in the buffers of a glTF file (sections 3.6.1 and 3.6.2 of the specification 2.0 of Khronos): buffers
    inside of the file, as base64 or as the binary chunk; views, accessors, and sparse accessors. *)

open Scc_base
open Scc_exact

type t

val make : path:string -> binary:string option -> budget:int ref -> Gltf_json.t -> (t, Diag.t) result
(** [binary] is the binary chunk of a GLB file. [budget] is how many elements may yet be read: it bounds the memory
    that a small file can ask for by naming one accessor often. Reading takes from it, and so may others. *)

val spend : t -> Gltf_json.t -> int -> (unit, Diag.t) result
(** Takes from the budget; beyond it is a fault at the value. *)

val positions : t -> Gltf_json.t -> (Vec.t array, Diag.t) result
(** Of the accessor that the value names: 32-bit numbers in threes, exactly. *)

val indices : t -> Gltf_json.t -> below:int -> (int array, Diag.t) result
(** Whole numbers of 1, 2 or 4 bytes, each less than [below]. *)
