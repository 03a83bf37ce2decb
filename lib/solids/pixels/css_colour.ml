open Scc_exact
open Svg_number

type colour = { rgb : int; alpha : Rat.t }
type paint = Nothing | Current | Colour of colour | Server of string * paint option

let bad text = raise (Bad (Printf.sprintf "the colour %S" text))

let unread text =
  raise
    (Unread
       (Printf.sprintf
          "the paint %S (colours are names of CSS, #rrggbb, rgb(), hsl(), hwb(), lab(), lch(), oklab(), oklch(), \
           and color() in srgb, srgb-linear and display-p3)"
          text))

let ratio a b = Rat.make (Z.of_int a) (Z.of_int b)
let between low high q = Rat.max low (Rat.min high q)
let part_of_one q = between Rat.zero Rat.one q

(* Of the levels from 0 to 255. *)
let together levels =
  let byte q = Z.to_int (Rat.round_to (between Rat.zero (Rat.of_int 255) q) ~quantum:Rat.one).num in
  List.fold_left (fun rgb q -> (rgb lsl 8) lor byte q) 0 levels

let hexadecimal text =
  let digit c =
    match c with
    | '0' .. '9' -> Char.code c - Char.code '0'
    | 'a' .. 'f' -> Char.code c - Char.code 'a' + 10
    | _ -> bad text
  in
  let n = String.length text - 1 in
  let digits = List.init n (fun i -> digit text.[i + 1]) in
  let rec pairs = function a :: b :: rest -> ((16 * a) + b) :: pairs rest | _ -> [] in
  let bytes =
    match n with
    | 3 | 4 -> List.map (fun d -> 17 * d) digits
    | 6 | 8 -> pairs digits
    | _ -> bad text
  in
  match bytes with
  | [ r; g; b ] -> { rgb = (r lsl 16) lor (g lsl 8) lor b; alpha = Rat.one }
  | [ r; g; b; a ] -> { rgb = (r lsl 16) lor (g lsl 8) lor b; alpha = ratio a 255 }
  | _ -> bad text

(* {1 Functions} *)

(* Three numbers and perhaps an opacity, each with its unit, and true if commas are between them. Between blanks a
   slash is before the opacity. *)
let arguments text inner =
  let part p = with_unit p in
  let part_or_none p = if p = "none" then (Rat.zero, "") else part p in
  match (String.split_on_char ',' inner, String.split_on_char '/' inner) with
  | [ _ ], [ colour; opacity ] ->
    (List.map part_or_none (words colour), Some (part_or_none (String.trim opacity)), false)
  | [ _ ], [ colour ] -> (List.map part_or_none (words colour), None, false)
  | [ a; b; c ], [ _ ] -> (List.map part [ a; b; c ], None, true)
  | [ a; b; c; opacity ], [ _ ] -> (List.map part [ a; b; c ], Some (part opacity), true)
  | _ -> bad text

(* The level from 0 to [whole] of a number, or of a percentage. *)
let level text whole (q, unit) =
  match unit with
  | "" -> q
  | "%" -> Rat.mul whole (Rat.div q (Rat.of_int 100))
  | _ -> bad text

let alpha text = function None -> Rat.one | Some a -> part_of_one (level text Rat.one a)

let degrees text (q, unit) =
  match unit with
  | "" | "deg" -> q
  | "grad" -> Rat.mul q (ratio 9 10)
  | "turn" -> Rat.mul q (Rat.of_int 360)
  (* 180 over pi, for a colour that is rounded to bytes. *)
  | "rad" -> Rat.mul q (ratio 57_295_779_513 1_000_000_000)
  | _ -> bad text

(* The formula of CSS Color 4: each level is l - s min(l, 1 - l) max(-1, min(k - 3, 9 - k, 1)). *)
let levels_of_hsl h s l =
  let a = Rat.mul s (Rat.min l (Rat.sub Rat.one l)) in
  let level n =
    let k = Rat.modulo (Rat.add (Rat.of_int n) (Rat.div h (Rat.of_int 30))) (Rat.of_int 12) in
    let up = Rat.min (Rat.sub k (Rat.of_int 3)) (Rat.sub (Rat.of_int 9) k) in
    Rat.sub l (Rat.mul a (Rat.max (Rat.of_int (-1)) (Rat.min up Rat.one)))
  in
  [ level 0; level 8; level 4 ]

let of_shares shares = together (List.map (Rat.mul (Rat.of_int 255)) shares)
let of_hsl h s l = of_shares (levels_of_hsl h s l)

(* With white and black; too much of both is a grey. *)
let of_hwb h white black =
  let both = Rat.add white black in
  if Rat.compare both Rat.one >= 0 then of_shares (List.init 3 (fun _ -> Rat.div white both))
  else
    let mixed level = Rat.add (Rat.mul level (Rat.sub Rat.one both)) white in
    of_shares (List.map mixed (levels_of_hsl h Rat.one Rat.half))

(* {2 By the formulas of CSS Color 4, for a colour that is rounded to bytes}

   What no screen of sRGB shows takes the nearest level of each part. *)

let encoded x = if x <= 0.0031308 then 12.92 *. x else (1.055 *. Float.pow x (1. /. 2.4)) -. 0.055
let decoded x = if x <= 0.04045 then x /. 12.92 else Float.pow ((x +. 0.055) /. 1.055) 2.4

let of_linear parts =
  let byte x = int_of_float (Float.round (255. *. Float.max 0. (Float.min 1. (encoded x)))) in
  List.fold_left (fun rgb x -> (rgb lsl 8) lor byte x) 0 parts

let times rows parts = List.map (fun row -> List.fold_left2 (fun sum a x -> sum +. (a *. x)) 0. row parts) rows

let of_p3 parts =
  of_linear
    (times
       [
         [ 1.2249401763; -0.2249401763; 0. ]; [ -0.0420569547; 1.0420569547; 0. ];
         [ -0.0196375546; -0.0786360456; 1.0982736001 ];
       ]
       (List.map decoded parts))

let of_oklab parts =
  let cones =
    times
      [
        [ 1.; 0.3963377774; 0.2158037573 ]; [ 1.; -0.1055613458; -0.0638541728 ];
        [ 1.; -0.0894841775; -1.2914855480 ];
      ]
      parts
  in
  of_linear
    (times
       [
         [ 4.0767416621; -3.3077115913; 0.2309699292 ]; [ -1.2684380046; 2.6097574011; -0.3413193965 ];
         [ -0.0041960863; -0.7034186147; 1.7076147010 ];
       ]
       (List.map (fun x -> x *. x *. x) cones))

(* From CIE Lab, whose white is D50, by the linear transform of Bradford. *)
let of_lab parts =
  let l, a, b = match parts with [ l; a; b ] -> (l, a, b) | _ -> invalid_arg "of_lab" in
  let kappa = 24389. /. 27. and epsilon = 216. /. 24389. in
  let middle = (l +. 16.) /. 116. in
  let from x = if x *. x *. x > epsilon then x *. x *. x else ((116. *. x) -. 16.) /. kappa in
  let y = if l > kappa *. epsilon then middle *. middle *. middle else l /. kappa in
  let white_x = 0.3457 /. 0.3585 and white_z = (1. -. 0.3457 -. 0.3585) /. 0.3585 in
  let d50 = [ white_x *. from (middle +. (a /. 500.)); y; white_z *. from (middle -. (b /. 200.)) ] in
  let d65 =
    times
      [
        [ 0.9554734215; -0.0230984549; 0.0632592432 ]; [ -0.0283697093; 1.0099953981; 0.0210414412 ];
        [ 0.0123140149; -0.0205076493; 1.3303659262 ];
      ]
      d50
  in
  of_linear
    (times
       [
         [ 3.2409699419; -1.5373831776; -0.4986107603 ]; [ -0.9692436363; 1.8759675015; 0.0415550574 ];
         [ 0.0556300797; -0.2039769589; 1.0569715142 ];
       ]
       d65)

(* Spaces that CSS has beside those that are read. *)
let other_spaces =
  String.split_on_char ' '
    "a98-rgb prophoto-rgb rec2020 xyz xyz-d50 xyz-d65 display-p3-linear rec2100-pq rec2100-hlg rec2100-linear"

(* color(): the name of a space, and three parts. *)
let in_space text inner =
  let inner = String.trim inner in
  let space, rest =
    match String.index_opt inner ' ' with
    | Some i -> (String.sub inner 0 i, String.sub inner i (String.length inner - i))
    | None -> bad text
  in
  let all of_levels =
    match arguments text rest with
    | ([ _; _; _ ] as levels), opacity, false ->
      { rgb = of_levels (List.map (level text Rat.one) levels); alpha = alpha text opacity }
    | _ -> bad text
  in
  let floats f levels = f (List.map Rat.to_float levels) in
  match space with
  | "srgb" -> all (fun levels -> together (List.map (Rat.mul (Rat.of_int 255)) levels))
  | "srgb-linear" -> all (floats of_linear)
  | "display-p3" -> all (floats of_p3)
  | _ when List.mem space other_spaces || String.starts_with ~prefix:"--" space -> unread text
  | _ -> bad text

(* Lightness up to [most], and two axes, or a chroma and its direction: 100 % of an axis, and of a chroma. *)
let of_lightness text inner ~most ~axis ~chroma convert =
  let part whole p = Rat.to_float (level text whole p) in
  match arguments text inner with
  | [ l; a; b ], opacity, false ->
    let l = Float.max 0. (Float.min (Rat.to_float most) (part most l)) in
    let parts =
      match chroma with
      | None -> [ l; part axis a; part axis b ]
      | Some whole ->
        let a = Float.max 0. (part whole a) and turn = Rat.to_float (degrees text b) *. Float.pi /. 180. in
        [ l; a *. Float.cos turn; a *. Float.sin turn ]
    in
    { rgb = convert parts; alpha = alpha text opacity }
  | _ -> bad text

let of_ok text inner = of_lightness text inner ~most:Rat.one ~axis:(ratio 2 5)
let of_cie text inner = of_lightness text inner ~most:(Rat.of_int 100) ~axis:(Rat.of_int 125)

let applied text name inner =
  (* Without commas a plain number is a percentage. *)
  let percent (q, unit) =
    if unit = "%" || unit = "" then part_of_one (Rat.div q (Rat.of_int 100)) else bad text
  in
  match name with
  | _ when String.starts_with ~prefix:"from " (String.trim inner) -> unread text
  | "color" -> in_space text inner
  | "oklab" -> of_ok text inner ~chroma:None of_oklab
  | "oklch" -> of_ok text inner ~chroma:(Some (ratio 2 5)) of_oklab
  | "lab" -> of_cie text inner ~chroma:None of_lab
  | "lch" -> of_cie text inner ~chroma:(Some (Rat.of_int 150)) of_lab
  | "rgb" | "rgba" -> (
      match arguments text inner with
      | ([ (_, r); (_, g); (_, b) ] as levels), opacity, commas when (not commas) || (r = g && g = b) ->
        { rgb = together (List.map (level text (Rat.of_int 255)) levels); alpha = alpha text opacity }
      | _ -> bad text)
  | "hwb" -> (
      match arguments text inner with
      | [ h; w; b ], opacity, false ->
        { rgb = of_hwb (degrees text h) (percent w) (percent b); alpha = alpha text opacity }
      | _ -> bad text)
  | "hsl" | "hsla" -> (
      let part ~commas ((_, unit) as p) = if commas && unit <> "%" then bad text else percent p in
      match arguments text inner with
      | [ h; s; l ], opacity, commas ->
        { rgb = of_hsl (degrees text h) (part ~commas s) (part ~commas l); alpha = alpha text opacity }
      | _ -> bad text)
  | _ -> unread text

let plain text =
  let n = String.length text in
  match List.assoc_opt text Colour_names.all with
  | Some rgb -> { rgb; alpha = Rat.one }
  | None when text = "transparent" -> { rgb = 0; alpha = Rat.zero }
  | None when n > 0 && text.[0] = '#' -> hexadecimal text
  | None -> (
      match String.index_opt text '(' with
      | Some i when text.[n - 1] = ')' ->
        applied text (String.sub text 0 i) (String.sub text (i + 1) (n - i - 2))
      | Some _ -> bad text
      | None ->
        let in_word c = (c >= 'a' && c <= 'z') || c = '-' || c = '_' in
        if text <> "" && String.for_all in_word text then unread text else bad text)

(* In SVG 1.1 a colour may have another one behind it, for printers. *)
let without_profile text =
  match List.find_opt (fun i -> String.sub text i 11 = " icc-color(")
          (List.init (max 0 (String.length text - 10)) Fun.id) with
  | Some i when i > 0 && text.[String.length text - 1] = ')' -> String.trim (String.sub text 0 i)
  | Some _ | None -> text

let colour text =
  let text = without_profile (String.lowercase_ascii (String.trim text)) in
  if text = "currentcolor" then None else Some (plain text)

(* {1 Paints} *)

let unquoted text =
  let text = String.trim text in
  let n = String.length text in
  if n >= 2 && (text.[0] = '"' || text.[0] = '\'') && text.[n - 1] = text.[0] then String.sub text 1 (n - 2)
  else text

(* The id of url(#id) at the start of a text, and what comes after it. *)
let server text =
  let text = String.trim text in
  let n = String.length text in
  match String.index_opt text ')' with
  | Some stop when n > 4 && String.lowercase_ascii (String.sub text 0 4) = "url(" ->
    let target = unquoted (String.sub text 4 (stop - 4)) in
    if target = "" || target.[0] <> '#' then raise (Unread (Printf.sprintf "the reference %S to another file"
                                                              target));
    Some (String.sub target 1 (String.length target - 1), String.trim (String.sub text (stop + 1) (n - stop - 1)))
  | _ -> None

let reference text = match server text with Some (id, "") -> Some id | Some _ | None -> None

let simple text =
  if String.lowercase_ascii (String.trim text) = "none" then Nothing
  else match colour text with None -> Current | Some c -> Colour c

let paint text =
  match server text with
  | Some (id, "") -> Server (id, None)
  | Some (id, rest) -> Server (id, Some (simple rest))
  | None -> simple text

(* {1 Words} *)

(* Those of CSS that are no colours of their own: of the system, of what uses an element, of all properties. *)
let others =
  String.split_on_char ' '
    "accentcolor accentcolortext activetext buttonborder buttonface buttontext canvas canvastext field fieldtext \
     graytext highlight highlighttext linktext mark marktext selecteditem selecteditemtext visitedtext \
     activeborder activecaption appworkspace background buttonhighlight buttonshadow captiontext inactiveborder \
     inactivecaption inactivecaptiontext infobackground infotext menu menutext scrollbar \
     threeddarkshadow threedface \
     threedhighlight threedlightshadow threedshadow window windowframe windowtext context-fill context-stroke \
     context-value child inherit initial unset revert revert-layer none currentcolor transparent"

let is_unknown word = not (List.mem_assoc word Colour_names.all || List.mem word others)
