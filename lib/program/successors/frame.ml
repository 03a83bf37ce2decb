exception Lost of string

let lost fmt = Printf.ksprintf (fun text -> raise (Lost text)) fmt

(* {1 Reading} *)

let number frame at =
  if at + 4 > String.length frame then lost "it ends too early";
  Int32.to_int (String.get_int32_le frame at) land 0xFFFF_FFFF

let numbers frame =
  let n = number frame 4 in
  if n > (String.length frame - 8) / 4 then lost "it is shorter than it says";
  Array.init n (fun i -> number frame (8 + (4 * i)))

let bytes_from numbers = 8 + (4 * Array.length numbers)

(* {1 Writing} *)

let put_number b n = Buffer.add_int32_le b (Int32.of_int n)
let put_numbers b = Array.iter (put_number b)

let put out head columns text =
  let size = List.fold_left (fun n b -> n + Buffer.length b) 0 columns in
  put_number out ((4 * List.length head) + size + String.length text);
  List.iter (put_number out) head;
  List.iter (Buffer.add_buffer out) columns;
  Buffer.add_string out text
