murk render - --radiosity - -o a.exr
