open Scc_exact
open Svg_number

type paint = Nothing | Colour of int | Current

type t = {
  fill : paint;
  color : int option;
  rule : Fill.rule;
  shown : bool;
  displayed : bool;
  opacity : Rat.t;
  fill_opacity : Rat.t;
  stroke : paint;
  stroke_width : Rat.t;
  stroke_opacity : Rat.t;
}

let initial =
  {
    fill = Colour 0; color = Some 0; rule = Nonzero; shown = true; displayed = true; opacity = Rat.one;
    fill_opacity = Rat.one; stroke = Nothing; stroke_width = Rat.one; stroke_opacity = Rat.one;
  }

let named =
  [
    ("black", 0x000000); ("silver", 0xc0c0c0); ("gray", 0x808080); ("grey", 0x808080); ("white", 0xffffff);
    ("maroon", 0x800000); ("red", 0xff0000); ("purple", 0x800080); ("fuchsia", 0xff00ff); ("magenta", 0xff00ff);
    ("green", 0x008000); ("lime", 0x00ff00); ("olive", 0x808000); ("yellow", 0xffff00); ("navy", 0x000080);
    ("blue", 0x0000ff); ("teal", 0x008080); ("aqua", 0x00ffff); ("cyan", 0x00ffff); ("orange", 0xffa500);
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

let paint text =
  if String.lowercase_ascii (String.trim text) = "currentcolor" then Current
  else match colour text with Some c -> Colour c | None -> Nothing

let property style (name, value) =
  match (name, value) with
  | _, ("initial" | "unset" | "revert" | "revert-layer") -> unread "the value %S of %s" value name
  | _, "inherit" -> style
  | "fill", _ -> { style with fill = paint value }
  | "color", "currentcolor" -> style
  | "color", _ -> { style with color = colour value }
  | "fill-rule", "nonzero" -> { style with rule = Fill.Nonzero }
  | "fill-rule", "evenodd" -> { style with rule = Fill.Even_odd }
  | "fill-rule", _ -> raise (Bad (Printf.sprintf "the fill-rule %S" value))
  | "visibility", _ -> { style with shown = value = "visible" }
  | "display", _ -> { style with displayed = style.displayed && value <> "none" }
  | "opacity", _ -> { style with opacity = Rat.mul style.opacity (share value) }
  | "fill-opacity", _ -> { style with fill_opacity = share value }
  | "stroke", _ -> { style with stroke = (if String.contains value '(' then Current else paint value) }
  | "stroke-width", _ -> { style with stroke_width = length value }
  | "stroke-opacity", _ -> { style with stroke_opacity = share value }
  | ("clip-path" | "mask" | "filter"), v when v <> "none" -> unread "%s" name
  | _ -> style

let of_properties around properties = List.fold_left property around properties

let fill s =
  let seen = Rat.compare (Rat.mul s.opacity s.fill_opacity) Rat.half >= 0 in
  match s.fill with
  | Colour c when seen -> Some c
  | Current when seen -> s.color
  | Nothing | Colour _ | Current -> None

let stroked s =
  let painted = match s.stroke with Nothing -> false | Colour _ -> true | Current -> Option.is_some s.color in
  painted && Rat.sign s.stroke_width > 0 && Rat.sign s.stroke_opacity > 0
