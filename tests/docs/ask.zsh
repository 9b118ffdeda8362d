# ask.zsh LINE...: what zsh offers at the end of each line, one a line, and an empty line behind those of each. A second
# zsh, on a terminal, prints its matches.
zmodload zsh/zpty
zpty shell zsh -f -i
until_said() {
    local line
    while zpty -r shell line; do
        line=${line//$'\r'/}
        [[ $line == *"<$1>"* && $line != *print* ]] && return
        [[ $1 == end && $line == *'offer<'* ]] && print -r -- ${${line##*offer<}%%>*}
    done
}
zpty -w shell 'PROMPT=; unset zle_bracketed_paste; stty -echo; print "<quiet>"'
until_said quiet
zpty -w shell 'autoload -Uz compinit; compinit -u -D; source ./_zsh
compadd() { local -a got; builtin compadd -O got "$@"; (( $#got )) && print -rl -- "offer<"${^got}">"; builtin compadd "$@" }
ask() { _main_complete; print "\n<end>" }; zle -C ask complete-word ask; bindkey "^T" ask; print "<ready>"'
until_said ready
for line in "$@"; do
    zpty -w -n shell "$line"$'\x14'
    until_said end
    print
    zpty -w -n shell $'\x15'  # empties the line
done
zpty -d shell
