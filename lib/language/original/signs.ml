let signs = [ ("\xE2\x88\xAA", "+  "); ("\xE2\x88\xA9", "*  "); ("\xE2\x88\x96", "-  ") ]

type state = Text | Line | Block of int | Quoted

let spelt text =
  let n = String.length text in
  let result = Bytes.of_string text in
  let starts i sign = i + String.length sign <= n && String.equal (String.sub text i (String.length sign))
                        sign in
  let rec go i state =
    if i < n then
      match state with
      | Line -> go (i + 1) (if text.[i] = '\n' || text.[i] = '\r' then Text else Line)
      | Quoted when text.[i] = '\\' -> go (i + 2) Quoted
      | Quoted -> go (i + 1) (match text.[i] with '"' | '\n' | '\r' -> Text | _ -> Quoted)
      | Block _ | Text when starts i "/*" -> go (i + 2) (match state with Block d -> Block (d + 1) | _ ->
          Block 1)
      | Block d when starts i "*/" -> go (i + 2) (if d = 1 then Text else Block (d - 1))
      | Block _ -> go (i + 1) state
      | Text when starts i "//" -> go (i + 2) Line
      | Text when text.[i] = '"' -> go (i + 1) Quoted
      | Text -> (
          match List.find_opt (fun (sign, _) -> starts i sign) signs with
          | Some (_, word) ->
            Bytes.blit_string word 0 result i 3;
            go (i + 3) Text
          | None -> go (i + 1) Text)
  in
  go 0 Text;
  Bytes.to_string result

let length text start = if start < String.length text && text.[start] = '\xE2' then 3 else 1
