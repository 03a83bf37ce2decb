open Bigarray

type place = Memory | Folder of { path : string; beyond : int }

let place = ref Memory
let in_memory = ref 0

(* Small tables share a file, of which this is what is left: systems allow some ten thousand mappings only. *)
let slab = 1 lsl 24

type ('a, 'b) left = { mutable slab : ('a, 'b, c_layout) Array1.t; mutable next : int }

let left_of_ints = { slab = Array1.create int c_layout 0; next = 0 }
let left_of_int32s = { slab = Array1.create int32 c_layout 0; next = 0 }
let left_of_int16s = { slab = Array1.create int16_signed c_layout 0; next = 0 }

let forget_slabs () =
  left_of_ints.next <- Array1.dim left_of_ints.slab;
  left_of_int32s.next <- Array1.dim left_of_int32s.slab;
  left_of_int16s.next <- Array1.dim left_of_int16s.slab

let to_folder path ~beyond =
  forget_slabs ();
  place := Folder { path; beyond }

let nowhere () =
  forget_slabs ();
  place := Memory

(* All of it is written once: who touches a page of a file with a hole on a full disk is killed. *)
let rec fill fd zeros left =
  if left > 0 then fill fd zeros (left - Unix.write fd zeros 0 (Int.min left (Bytes.length zeros)))

let map kind folder count =
  let bytes = count * kind_size_in_bytes kind in
  let name = Filename.temp_file ~temp_dir:folder "table" ".tmp" in
  let fd = Unix.openfile name [ O_RDWR; O_CLOEXEC ] 0o600 in
  Fun.protect
    ~finally:(fun () -> Unix.close fd)
    (fun () ->
       Unix.unlink name;
       fill fd (Bytes.make 65536 '\000') bytes;
       array1_of_genarray (Unix.map_file fd kind c_layout true [| count |]))

(* Where a file cannot be made, as on a full disk, memory is what is left. *)
let mapped kind folder count =
  match map kind folder count with
  | table -> Some table
  | exception (Unix.Unix_error _ | Sys_error _) -> None

let from_slab kind left folder count =
  let per_slab = slab / kind_size_in_bytes kind in
  if count > per_slab / 4 then mapped kind folder count
  else begin
    let part () =
      let table = Array1.sub left.slab left.next count in
      left.next <- left.next + count;
      Some table
    in
    if left.next + count <= Array1.dim left.slab then part ()
    else
      match mapped kind folder per_slab with
      | None -> None
      | Some slab ->
        left.slab <- slab;
        left.next <- 0;
        part ()
  end

let create kind left count =
  let bytes = count * kind_size_in_bytes kind in
  let here () =
    in_memory := !in_memory + bytes;
    Array1.create kind c_layout count
  in
  match !place with
  | Folder { path; beyond } when !in_memory + bytes > beyond -> (
      match from_slab kind left path count with Some table -> table | None -> here ())
  | Folder _ | Memory -> here ()

let takes bytes = match !place with Folder { beyond; _ } -> !in_memory + bytes > beyond | Memory -> false
let ints count = create int left_of_ints count
let int32s count = create int32 left_of_int32s count
let int16s count = create int16_signed left_of_int16s count
