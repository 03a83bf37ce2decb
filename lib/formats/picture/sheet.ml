open Scc_svg

let width_limits = (100, 10_000)
let margin = 16
let top ~title = match title with None -> 0 | Some _ -> 24
let number = string_of_int
let remark =
  "<!-- A lossy export: what is seen is found exactly, and its places are rounded to 1/100 of a pixel. -->"

type t = {
  size : int * int;
  title : string option;
  told : string;
  defs : string list;
  bar : Canvas.t option;
  key : Key.entry list;
  notes : Key.note list;
}

let svg t drawing =
  let width, below = t.size in
  let left = margin and inside = width - (2 * margin) in
  let scale, bar_high =
    match t.bar with None -> ([], 0) | Some canvas -> (Key.bar canvas ~left ~top:below, 28)
  in
  let rows, rows_high = Key.rows ~left ~width:inside ~top:(below + bar_high) t.key in
  let notes, notes_high = Key.notes ~left ~width:inside ~top:(below + bar_high + rows_high) t.notes in
  let explained = bar_high + rows_high + notes_high in
  let height = below + if explained = 0 then 0 else explained + 10 in
  let heading =
    match t.title with
    | None -> []
    | Some text ->
      let at = [ ("x", number margin); ("y", "25"); ("fill", "#1f2328"); ("font-size", "15") ] in
      Svg.text at text
  in
  let size = [ ("width", number width); ("height", number height) ] in
  let attributes =
    [ ("xmlns", "http://www.w3.org/2000/svg"); ("viewBox", Printf.sprintf "0 0 %d %d" width height) ]
    @ size
    @ [
      ("role", "img"); ("font-family", "system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif");
      ("font-size", "13"); ("stroke-linejoin", "round"); ("stroke-linecap", "round");
    ]
  in
  let body =
    Svg.title t.told @ [ remark ]
    @ (match t.defs with [] -> [] | _ :: _ -> Svg.tag "defs" [] t.defs)
    @ Svg.tag "rect" (size @ [ ("fill", "#ffffff") ]) []
    @ heading @ drawing @ scale @ rows @ notes
  in
  String.concat "\n" (Svg.tag "svg" attributes body) ^ "\n"
