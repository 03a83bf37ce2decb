open Scc_drawing

let width_limits = (100, 10_000)
let margin = 16
let top ~title = match title with None -> 0 | Some _ -> 24
let number = string_of_int
let remark =
  "<!-- A lossy export: what is seen is found exactly, and its places are rounded to 1/100 of a pixel. -->"

let svg (canvas : Canvas.t) ~title ~told ~defs ~bar ~key drawing =
  let below = canvas.height in
  let bar_high = if bar then 28 else 0 in
  let scale = if bar then Key.bar canvas ~left:margin ~top:below else [] in
  let rows, rows_high =
    Key.rows ~left:margin ~width:(canvas.width - (2 * margin)) ~top:(below + bar_high) key
  in
  let explained = bar_high + rows_high in
  let height = below + if explained = 0 then 0 else explained + 10 in
  let heading =
    match title with
    | None -> []
    | Some text ->
      let at = [ ("x", number margin); ("y", "25"); ("fill", "#1f2328"); ("font-size", "15") ] in
      Svg.text at text
  in
  let size = [ ("width", number canvas.width); ("height", number height) ] in
  let attributes =
    [ ("xmlns", "http://www.w3.org/2000/svg"); ("viewBox", Printf.sprintf "0 0 %d %d" canvas.width height) ]
    @ size
    @ [
      ("role", "img"); ("font-family", "system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif");
      ("font-size", "13"); ("stroke-linejoin", "round"); ("stroke-linecap", "round");
    ]
  in
  let body =
    Svg.title told @ [ remark ]
    @ (match defs with [] -> [] | _ :: _ -> Svg.tag "defs" [] defs)
    @ Svg.tag "rect" (size @ [ ("fill", "#ffffff") ]) []
    @ heading @ drawing @ scale @ rows
  in
  String.concat "\n" (Svg.tag "svg" attributes body) ^ "\n"
