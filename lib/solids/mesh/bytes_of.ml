open Scc_base

let unsigned ~big_endian text offset width =
  match (width, big_endian) with
  | 1, _ -> String.get_uint8 text offset
  | 2, true -> String.get_uint16_be text offset
  | 2, false -> String.get_uint16_le text offset
  | 4, true -> (String.get_uint16_be text offset lsl 16) lor String.get_uint16_be text (offset + 2)
  | 4, false -> String.get_uint16_le text offset lor (String.get_uint16_le text (offset + 2) lsl 16)
  | _ -> Bug.fail __POS__ "an integer of a width that no format has"

let signed ~big_endian text offset width =
  let v = unsigned ~big_endian text offset width in
  if v >= 1 lsl ((8 * width) - 1) then v - (1 lsl (8 * width)) else v

let real ~path ~big_endian text offset width =
  let x =
    match (width, big_endian) with
    | 4, true -> Int32.float_of_bits (String.get_int32_be text offset)
    | 4, false -> Int32.float_of_bits (String.get_int32_le text offset)
    | 8, true -> Int64.float_of_bits (String.get_int64_be text offset)
    | 8, false -> Int64.float_of_bits (String.get_int64_le text offset)
    | _ -> Bug.fail __POS__ "a real number of a width that no format has"
  in
  if Float.is_finite x then Ok (Q.of_float x)
  else
    Text.error_at ~path offset "a coordinate must be a finite number, but the one at byte %d is not" offset
