open Scc_exact
open Svg_number

type t = { fill : int option; rule : Fill.rule; shown : bool; displayed : bool; opacity : Rat.t; stroked : bool }

let initial =
  { fill = Some 0; rule = Nonzero; shown = true; displayed = true; opacity = Rat.one; stroked = false }

let named =
  [
    ("black", 0x000000); ("silver", 0xc0c0c0); ("gray", 0x808080); ("grey", 0x808080); ("white", 0xffffff);
    ("maroon", 0x800000); ("red", 0xff0000); ("purple", 0x800080); ("fuchsia", 0xff00ff); ("magenta", 0xff00ff);
    ("green", 0x008000); ("lime", 0x00ff00); ("olive", 0x808000); ("yellow", 0xffff00); ("navy", 0x000080);
    ("blue", 0x0000ff); ("teal", 0x008080); ("aqua", 0x00ffff); ("cyan", 0x00ffff); ("orange", 0xffa500);
    ("currentcolor", 0x000000);
  ]

let unread format = Printf.ksprintf (fun m -> raise (Unread m)) format

let hexadecimal text =
  match int_of_string_opt ("0x" ^ text) with
  | Some n when not (String.contains text '_') -> n
  | _ -> raise (Bad (Printf.sprintf "the colour \"#%s\"" text))

let colour text =
  let text = String.lowercase_ascii (String.trim text) in
  let n = String.length text in
  if text = "none" || text = "transparent" then None
  else if n = 7 && text.[0] = '#' then Some (hexadecimal (String.sub text 1 6))
  else if n = 4 && text.[0] = '#' then begin
    let c = hexadecimal (String.sub text 1 3) in
    Some ((17 * (c lsr 8) lsl 16) lor (17 * ((c lsr 4) land 15) lsl 8) lor (17 * (c land 15)))
  end
  else if n > 5 && String.sub text 0 4 = "rgb(" && text.[n - 1] = ')' && not (String.contains text '%') then
    match all (String.sub text 4 (n - 5)) with
    | [ r; g; b ] ->
      let level q = max 0 (min 255 (Z.to_int (Rat.round_to q ~quantum:Rat.one).num)) in
      Some ((level r lsl 16) lor (level g lsl 8) lor level b)
    | _ -> raise (Bad (Printf.sprintf "the colour %S" text))
  else
    match List.assoc_opt text named with
    | Some c -> Some c
    | None -> unread "the paint %S (colours are #rrggbb, rgb(r, g, b) or one of the sixteen names)" text

(* A share, as a number or in percent. *)
let share text =
  let c = { text; at = 0 } in
  let q = number c in
  let q = if String.contains text '%' then Rat.div q (Rat.of_int 100) else q in
  Rat.max Rat.zero (Rat.min Rat.one q)

let property style (name, value) =
  let value = String.trim value in
  match (name, value) with
  | _, "inherit" -> style
  | "fill", _ -> { style with fill = colour value }
  | "fill-rule", "nonzero" -> { style with rule = Fill.Nonzero }
  | "fill-rule", "evenodd" -> { style with rule = Fill.Even_odd }
  | "fill-rule", _ -> raise (Bad (Printf.sprintf "the fill-rule %S" value))
  | "visibility", _ -> { style with shown = value = "visible" }
  | "display", _ -> { style with displayed = style.displayed && value <> "none" }
  | ("opacity" | "fill-opacity"), _ -> { style with opacity = Rat.mul style.opacity (share value) }
  | "stroke", _ -> { style with stroked = not (List.mem value [ "none"; "transparent" ]) }
  | ("clip-path" | "mask" | "filter"), v when v <> "none" -> unread "%s" name
  | _ -> style

let declarations text =
  List.filter_map
    (fun part ->
       match String.index_opt part ':' with
       | Some i -> Some (String.trim (String.sub part 0 i), String.sub part (i + 1) (String.length part - i - 1))
       | None -> None)
    (String.split_on_char ';' text)

(* What style says comes after, and so counts. *)
let of_element around attributes =
  let style = List.fold_left property around attributes in
  match List.assoc_opt "style" attributes with
  | None -> style
  | Some text -> List.fold_left property style (declarations text)

(* {1 Transforms} *)

let one_transform name values =
  let zero = Rat.zero in
  match (name, values) with
  | "matrix", [ a; b; c; d; e; f ] -> { Plane_map.a; b; c; d; e; f }
  | "translate", [ x; y ] -> Plane_map.translation x y
  | "translate", [ x ] -> Plane_map.translation x zero
  | "scale", [ x; y ] -> Plane_map.scaling x y
  | "scale", [ x ] -> Plane_map.scaling x x
  | "rotate", [ a ] -> Plane_map.rotation a
  | "rotate", [ a; x; y ] ->
    Plane_map.(compose (translation x y) (compose (rotation a) (translation (Rat.neg x) (Rat.neg y))))
  | ("skewX" | "skewY"), [ a ] -> (
      match Plane_map.skewing (if name = "skewX" then `X else `Y) a with
      | Some m -> m
      | None -> raise (Bad "a skew by a right angle"))
  | _ -> raise (Bad (Printf.sprintf "the transform %S with %d numbers" name (List.length values)))

let transform text =
  let c = { text; at = 0 } in
  let rec go map =
    if ended c then map
    else
      match String.index_from_opt text c.at '(' with
      | None -> raise (Bad (Printf.sprintf "the transform %S" text))
      | Some i -> (
          match String.index_from_opt text i ')' with
          | None -> raise (Bad (Printf.sprintf "the transform %S" text))
          | Some j ->
            let name = String.trim (String.sub text c.at (i - c.at)) in
            c.at <- j + 1;
            go (Plane_map.compose map (one_transform name (all (String.sub text (i + 1) (j - i - 1))))))
  in
  go Plane_map.identity
