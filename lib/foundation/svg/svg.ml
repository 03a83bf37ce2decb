let escape text =
  let buffer = Buffer.create (String.length text) in
  String.iter (Scc_base.Markup.add buffer) (Scc_base.Visible.text text);
  Buffer.contents buffer

let number = Scc_exact.Decimal.fixed ~places:2

let opened name attributes =
  String.concat "" (("<" ^ name) :: List.map (fun (k, v) -> " " ^ k ^ "=\"" ^ escape v ^ "\"") attributes)

let tag name attributes = function
  | [] -> [ opened name attributes ^ "/>" ]
  | inside -> ((opened name attributes ^ ">") :: List.map (fun line -> "  " ^ line) inside) @ [ "</" ^ name ^ ">" ]

let one_line name attributes text = [ opened name attributes ^ ">" ^ escape text ^ "</" ^ name ^ ">" ]
let text attributes text = one_line "text" attributes text
let title text = if text = "" then [] else one_line "title" [] text
let point (x, y) = number x ^ " " ^ number y

let closed polygons =
  let polygon points = "M" ^ String.concat " L" (List.map point points) ^ " Z" in
  String.concat " " (List.map polygon polygons)

let segments all = String.concat " " (List.map (fun (a, b) -> "M" ^ point a ^ " L" ^ point b) all)
