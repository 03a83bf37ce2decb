open Scc_codec

(* Numbers in common are given out from 0, as things come up. *)
type t = {
  mutable common : int array;  (** of the number here; -1 for none *)
  mutable here : int array;  (** of the number in common *)
  mutable size : int;
}

let create () = { common = [||]; here = [||]; size = 0 }

let longer array length =
  let more = Array.make (Int.max 64 (2 * length)) (-1) in
  Array.blit array 0 more 0 (Array.length array);
  more

let common d number = if number < Array.length d.common then Array.unsafe_get d.common number else -1
let knows d number = common d number >= 0

let add d number =
  if number >= Array.length d.common then d.common <- longer d.common (number + 1);
  if d.size >= Array.length d.here then d.here <- longer d.here (d.size + 1);
  d.common.(number) <- d.size;
  d.here.(d.size) <- number;
  d.size <- d.size + 1

let put d buffer ~bytes number =
  match common d number with
  | -1 ->
    let text = bytes number in
    Packed.put_nat buffer d.size;
    Packed.put_nat buffer (String.length text);
    Buffer.add_string buffer text;
    add d number
  | k -> Packed.put_nat buffer k

let read d source ~number =
  let k = Packed.below (d.size + 1) ~what:"the number in common" source in
  if k < d.size then d.here.(k)
  else begin
    let number = number (Packed.text source) in
    add d number;
    number
  end
