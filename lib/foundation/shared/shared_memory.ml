open Bigarray

type numbers = (int, int_elt, c_layout) Array1.t
type halves = (int32, int32_elt, c_layout) Array1.t
type bytes = (int, int8_unsigned_elt, c_layout) Array1.t

(* A mapping of this device is memory of nobody else, which is there once it is written to: it needs no file, and
   no room for one. *)
let device = "/dev/zero"

(* Mappings take addresses, most of which are never written to: under a limit on these there would be none left for
   anything else. *)
let are_addresses_limited () = Option.is_some (Scc_system.Resources.limit Addresses)

let map kind count =
  if are_addresses_limited () then None
  else
    match Unix.openfile device [ O_RDWR; O_CLOEXEC ] 0 with
    | exception Unix.Unix_error _ -> None
    | fd ->
      Fun.protect
        ~finally:(fun () -> Unix.close fd)
        (fun () ->
           match Unix.map_file fd kind c_layout true [| count |] with
           | memory -> Some (array1_of_genarray memory)
           | exception (Unix.Unix_error _ | Sys_error _) -> None)

let numbers count = map int count
(* Hardly any system refuses so much, as none of it is taken. *)
let most_bits = 31
let least_bits = 20

let rec of_bits bits =
  if bits < least_bits then None
  else match numbers (1 lsl bits) with
    | Some memory -> Some memory
    | None -> of_bits (bits - 1)

let many_numbers () = of_bits most_bits
let halves count = map int32 count
let all list = if List.for_all Option.is_some list then Some (List.filter_map Fun.id list) else None
let bytes count = map int8_unsigned count

external exchange_half : halves -> (int[@untagged]) -> (int[@untagged]) -> (int[@untagged]) -> (int[@untagged])
  = "scc_exchange_half_boxed" "scc_exchange_half"
[@@noalloc]

external release_half : halves -> (int[@untagged]) -> (int[@untagged]) -> unit
  = "scc_release_half_boxed" "scc_release_half"
[@@noalloc]

external fetch_and_add : numbers -> (int[@untagged]) -> (int[@untagged]) -> (int[@untagged])
  = "scc_fetch_and_add_boxed" "scc_fetch_and_add"
[@@noalloc]

external acquire : numbers -> (int[@untagged]) -> (int[@untagged]) = "scc_acquire_boxed" "scc_acquire" [@@noalloc]
external release : numbers -> (int[@untagged]) -> (int[@untagged]) -> unit = "scc_release_boxed" "scc_release"
[@@noalloc]

let check i table = if i < 0 || i >= Array1.dim table then Scc_base.Bug.fail __POS__ "an index out of range"

let exchange halves i ~from ~into =
  check i halves;
  exchange_half halves i from into <> 0

let write_half halves i number =
  check i halves;
  release_half halves i number

let add numbers i more =
  check i numbers;
  fetch_and_add numbers i more

let read numbers i =
  check i numbers;
  acquire numbers i

let write numbers i number =
  check i numbers;
  release numbers i number

external compare_exchange :
  numbers -> (int[@untagged]) -> (int[@untagged]) -> (int[@untagged]) -> (int[@untagged])
  = "scc_exchange_boxed" "scc_exchange"
[@@noalloc]

let rec raise_to numbers i number =
  let known = read numbers i in
  if known < number && compare_exchange numbers i known number = 0 then raise_to numbers i number

external exchange_number : numbers -> (int[@untagged]) -> (int[@untagged]) -> (int[@untagged])
  = "scc_swap_boxed" "scc_swap"
[@@noalloc]

let swap numbers i number =
  check i numbers;
  exchange_number numbers i number
