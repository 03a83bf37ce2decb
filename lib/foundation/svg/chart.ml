open Scc_exact

type point = { x : Rat.t; y : Rat.t; band : (Rat.t * Rat.t) option }
type curve = { name : string; pieces : point list list }
type panel = { title : string; curves : curve list }

type amount = Nothing | Named of string | Amount of Rat.t
type cell = { said : string; amount : amount }
type map = { title : string; rows : string array; columns : string array; cells : cell array array }

(* {1 Axes} *)

let ten n = if n >= 0 then Rat.make (Z.pow (Z.of_int 10) n) Z.one else Rat.make Z.one (Z.pow (Z.of_int 10) (-n))
let ceiling r = Z.neg (Rat.floor (Rat.neg r))

let ticks ~least ~greatest ~about =
  let range = Rat.sub greatest least in
  if Rat.sign range <= 0 then [ least ]
  else
    let raw = Rat.div range (Rat.of_int about) in
    let power = ten (Decimal.order_of_magnitude raw) in
    let enough k = Rat.compare (Rat.mul (Rat.of_int k) power) raw >= 0 in
    let step = Rat.mul (Rat.of_int (List.find enough [ 1; 2; 5; 10 ])) power in
    let first = ceiling (Rat.div least step) and last = Rat.floor (Rat.div greatest step) in
    List.init (Z.to_int (Z.sub last first) + 1) (fun i ->
        Rat.mul step (Rat.make (Z.add first (Z.of_int i)) Z.one))

let tick_text r = match Decimal.exact r with Some text -> text | None -> Decimal.significant ~digits:6 r

(* From a range of numbers to one of the picture. *)
type axis = { least : Rat.t; greatest : Rat.t; from : Rat.t; until : Rat.t }

(* A range of one number is made wider, so that it lies in the middle. *)
let axis numbers ~from ~until =
  match numbers with
  | [] -> { least = Rat.zero; greatest = Rat.one; from; until }
  | first :: rest ->
    let least, greatest = Rat.span first rest in
    if Rat.equal least greatest then
      { least = Rat.sub least Rat.one; greatest = Rat.add greatest Rat.one; from; until }
    else { least; greatest; from; until }

let place a r =
  let share = Rat.div (Rat.sub r a.least) (Rat.sub a.greatest a.least) in
  Rat.add a.from (Rat.mul share (Rat.sub a.until a.from))

(* {1 The picture} *)

let width = 720
let height = 200
let left = 84
let right = 24
let above = 28
let below = 40
let head = 52
let int = string_of_int
let grey = "#667788"

let path data attributes = Svg.tag "path" (("d", data) :: attributes) []

let joined points =
  match points with
  | [] -> ""
  | first :: rest ->
    let at (x, y) = Svg.number x ^ " " ^ Svg.number y in
    "M" ^ at first ^ String.concat "" (List.map (fun p -> " L" ^ at p) rest)

let band xs ys colour piece =
  let edge side = List.filter_map (fun p -> Option.map (fun b -> (place xs p.x, place ys (side b))) p.band) piece
  in match edge fst with
  | [] -> []
  | low -> path (Svg.closed [ low @ List.rev (edge snd) ]) [ ("fill", colour); ("fill-opacity", "0.18") ]

let few = 80

let curve xs ys i c =
  let colour = Palette.colour i in
  let at p = (place xs p.x, place ys p.y) in
  let line piece =
    path (joined (List.map at piece)) [ ("fill", "none"); ("stroke", colour); ("stroke-width", "1.6") ]
  in
  let dot p =
    let x, y = at p in
    Svg.tag "circle" [ ("cx", Svg.number x); ("cy", Svg.number y); ("r", "2"); ("fill", colour) ] []
  in
  let dots piece =
    match piece with
    | [ p ] -> dot p
    | _ -> if List.length piece <= few then List.concat_map dot piece else []
  in
  Svg.tag "g" []
    (Svg.title c.name
     @ List.concat_map (fun piece -> band xs ys colour piece @ line piece @ dots piece) c.pieces)

let rule ~x1 ~y1 ~x2 ~y2 colour =
  path (Svg.segments [ ((x1, y1), (x2, y2)) ]) [ ("stroke", colour); ("stroke-width", "0.6") ]

let label ~x ~y ~anchor text =
  Svg.text [ ("x", Svg.number x); ("y", Svg.number y); ("text-anchor", anchor); ("fill", grey) ] text

let grid xs ys =
  let add = Rat.add and some n = Rat.of_int n in
  let upright x =
    let at = place xs x in
    rule ~x1:at ~y1:ys.from ~x2:at ~y2:ys.until "#dde2e8"
    @ label ~x:at ~y:(add ys.from (some 15)) ~anchor:"middle" (tick_text x)
  and level y =
    let at = place ys y in
    rule ~x1:xs.from ~y1:at ~x2:xs.until ~y2:at "#dde2e8"
    @ label ~x:(add xs.from (some (-6))) ~y:(add at (some 4)) ~anchor:"end" (tick_text y)
  in
  List.concat_map upright (ticks ~least:xs.least ~greatest:xs.greatest ~about:8)
  @ List.concat_map level (ticks ~least:ys.least ~greatest:ys.greatest ~about:5)

(* The names of several curves stand in a row behind the title. *)
let names panel ~y =
  match panel.curves with
  | [] | [ _ ] -> []
  | curves ->
    let place i = Rat.of_int (left + 160 + (110 * i)) in
    List.concat
      (List.mapi
         (fun i c ->
            Svg.text
              [ ("x", Svg.number (place i)); ("y", Svg.number y); ("fill", Palette.colour i) ]
              c.name)
         curves)

let heights p = p.y :: (match p.band with None -> [] | Some (a, b) -> [ a; b ])
let points panel = List.concat_map (fun c -> List.concat c.pieces) panel.curves

let panel_height = above + height + below

let panel xs top (p : panel) =
  let base = Rat.of_int (top + above + height) in
  let ys = axis (List.concat_map heights (points p)) ~from:base ~until:(Rat.of_int (top + above)) in
  let y = Rat.of_int (top + 16) in
  Svg.text [ ("x", int left); ("y", Svg.number y); ("font-weight", "bold") ] p.title
  @ names p ~y @ grid xs ys
  @ rule ~x1:xs.from ~y1:base ~x2:xs.until ~y2:base grey
  @ List.concat (List.mapi (curve xs ys) p.curves)

(* {1 Maps} *)

let nothing = "#e4e7eb"

let amounts m =
  let of_cell c = match c.amount with Amount r -> Some r | Nothing | Named _ -> None in
  List.concat_map (fun row -> List.filter_map of_cell (Array.to_list row)) (Array.to_list m.cells)

(* From pale to dark, in steps of one in a hundred. *)
let shade ~least ~greatest r =
  let range = Rat.sub greatest least in
  let share =
    if Rat.sign range = 0 then 50
    else Z.to_int (Rat.floor (Rat.div (Rat.mul (Rat.of_int 100) (Rat.sub r least)) range))
  in
  Palette.hex (Palette.mix (0.90, 0.94, 0.98) (0.10, 0.25, 0.50) (float_of_int share /. 100.))

let fill named amounts = function
  | Nothing -> nothing
  | Named name -> Option.value (List.assoc_opt name named) ~default:nothing
  | Amount r ->
    let extreme f = List.fold_left f r amounts in
    shade ~least:(extreme Rat.min) ~greatest:(extreme Rat.max) r

let cell_height m = Int.max 4 (Int.min 28 (300 / Int.max 1 (Array.length m.rows)))
let map_height m = above + (cell_height m * Array.length m.rows) + below

(* So few labels that they do not run into each other. *)
let labelled ~most n i = i mod ((n + most - 1) / most) = 0

let between_amounts = function
  | [] -> ""
  | r :: rest ->
    let text f = Decimal.significant ~digits:6 (List.fold_left f r rest) in
    Printf.sprintf "   %s to %s" (text Rat.min) (text Rat.max)

let map named top m =
  let count = Array.length m.columns and high = cell_height m in
  let amounts = amounts m in
  let base = top + above + (high * Array.length m.rows) in
  let inner = Rat.of_int (width - left - right) in
  let x i = Rat.add (Rat.of_int left) (Rat.div (Rat.mul inner (Rat.of_int i)) (Rat.of_int count)) in
  let wide = Svg.number (Rat.div inner (Rat.of_int (Int.max 1 count))) in
  let cell j i c =
    Svg.tag "rect"
      [
        ("x", Svg.number (x i)); ("y", int (base - ((j + 1) * high))); ("width", wide); ("height", int high);
        ("fill", fill named amounts c.amount); ("stroke", "#ffffff"); ("stroke-width", "0.5");
      ]
      (Svg.title c.said)
  in
  let row j cells =
    let y = Rat.of_int (base - (j * high) - (high / 2) + 4) in
    let name = if labelled ~most:14 (Array.length m.rows) j then m.rows.(j) else "" in
    (if name = "" then [] else label ~x:(Rat.of_int (left - 6)) ~y ~anchor:"end" name)
    @ List.concat (List.mapi (cell j) (Array.to_list cells))
  in
  let column i name =
    if labelled ~most:12 count i then
      let middle = Rat.middle (x i) (x (i + 1)) in
      label ~x:middle ~y:(Rat.of_int (base + 15)) ~anchor:"middle" name
    else []
  in
  Svg.text
    [ ("x", int left); ("y", int (top + 16)); ("font-weight", "bold") ]
    (m.title ^ between_amounts amounts)
  @ List.concat (List.mapi row (Array.to_list m.cells))
  @ List.concat (List.mapi column (Array.to_list m.columns))

(* The colours of the names that are there. *)
let legend named maps ~y =
  let is_named name c = match c.amount with Named n -> String.equal n name | Nothing | Amount _ -> false in
  let is_there name =
    List.exists (fun m -> Array.exists (Array.exists (is_named name)) m.cells) maps
  in
  let one i (name, colour) =
    let x = left + (130 * i) in
    Svg.tag "rect" [ ("x", int x); ("y", int (y - 10)); ("width", "12"); ("height", "12"); ("fill", colour) ] []
    @ Svg.text [ ("x", int (x + 17)); ("y", int y); ("fill", grey) ] name
  in
  List.concat (List.mapi one (List.filter (fun (name, _) -> is_there name) named))

(* {1 The whole} *)

(* What is drawn at the height that is reached, one below the other. *)
let stacked height draw top list =
  List.fold_left (fun (top, lines) item -> (top + height item, lines @ draw top item)) (top, []) list

let sheet ~title ~caption ~x ~named panels maps =
  let numbers = List.concat_map (fun p -> List.map (fun point -> point.x) (points p)) panels in
  let xs = axis numbers ~from:(Rat.of_int left) ~until:(Rat.of_int (width - right)) in
  let top, drawn_panels = stacked (fun _ -> panel_height) (panel xs) head panels in
  let top, drawn_maps = stacked map_height (map named) top maps in
  let total = top + 12 in
  let inside =
    Svg.title title
    @ Svg.tag "rect" [ ("width", int width); ("height", int total); ("fill", "#ffffff") ] []
    @ Svg.text [ ("x", int left); ("y", "22"); ("font-size", "15"); ("font-weight", "bold") ] title
    @ Svg.text [ ("x", int left); ("y", "40"); ("fill", grey) ] caption
    @ drawn_panels @ drawn_maps
    @ legend named maps ~y:(total - 8)
    @ label ~x:(Rat.of_int (width - right)) ~y:(Rat.of_int (total - 8)) ~anchor:"end" x
  in
  let document =
    Svg.tag "svg"
      [
        ("xmlns", "http://www.w3.org/2000/svg"); ("viewBox", Printf.sprintf "0 0 %d %d" width total);
        ("width", int width); ("height", int total); ("font-family", "sans-serif"); ("font-size", "12");
        ("fill", "#223344");
      ]
      inside
  in
  String.concat "\n" document ^ "\n"
